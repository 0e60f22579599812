#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <string>

#include "ddtool/robot/laser_scan.hpp"
#include "ddtool/robot/pose2.hpp"
#include "logs/messages/ros_messages.hpp"

namespace ddtool {

/// A pose in the plane as a message: z, roll and pitch are 0.
RosPose to_ros_pose(const Pose2& pose);
/// The x, y and yaw of a pose; z, roll and pitch are dropped.
Pose2 to_pose2(const Eigen::Isometry3d& pose);
/// The quaternion is normalised; from one that has zero length or is not finite the rotation is NaN.
Eigen::Isometry3d to_isometry(const RosPose& pose);

/// No return becomes +inf and an invalid beam NaN, as REP 117 defines it; angle_max is the angle of the last beam.
RosLaserScan scan_message(const LaserScan& scan, const std::string& frame_id);
RosOdometry odometry_message(std::int64_t stamp_ns, const std::string& frame_id, const std::string& child_frame_id,
                             const Pose2& frame_from_child);
RosPoseStamped pose_message(std::int64_t stamp_ns, const std::string& frame_id, const Pose2& pose);
RosTFMessage transform_message(std::int64_t stamp_ns, const std::string& frame_id, const std::string& child_frame_id,
                               const Pose2& frame_from_child);

}  // namespace ddtool

#include "logs/messages/ros_conversions.hpp"

#include <cmath>
#include <limits>

namespace ddtool {

RosPose to_ros_pose(const Pose2& pose) {
    const double half_rad = pose.theta_rad / 2.0;
    return {{pose.x_m, pose.y_m, 0.0}, {0.0, 0.0, std::sin(half_rad), std::cos(half_rad)}};
}

Pose2 to_pose2(const Eigen::Isometry3d& pose) {
    const Eigen::Matrix3d& rotation = pose.linear();
    return {pose.translation().x(), pose.translation().y(), std::atan2(rotation(1, 0), rotation(0, 0))};
}

Eigen::Isometry3d to_isometry(const RosPose& pose) {
    const auto& [position, orientation] = pose;
    Eigen::Quaterniond rotation(orientation.w, orientation.x, orientation.y, orientation.z);
    const double length = rotation.norm();
    Eigen::Isometry3d frame_from_child(Eigen::Translation3d(position.x, position.y, position.z));
    frame_from_child.linear() = length > 0.0 && std::isfinite(length)
                                    ? rotation.normalized().toRotationMatrix()
                                    : Eigen::Matrix3d::Constant(std::numeric_limits<double>::quiet_NaN());
    return frame_from_child;
}

RosLaserScan scan_message(const LaserScan& scan, const std::string& frame_id) {
    RosLaserScan message;
    message.header = {{scan.stamp_ns}, frame_id};
    message.angle_min = static_cast<float>(scan.angle_min_rad);
    message.angle_max = static_cast<float>(scan.angle_rad(scan.ranges_m.empty() ? 0 : scan.ranges_m.size() - 1));
    message.angle_increment = static_cast<float>(scan.angle_increment_rad);
    message.time_increment = static_cast<float>(scan.time_increment_s);
    message.scan_time = static_cast<float>(scan.scan_time_s);
    message.range_min = static_cast<float>(scan.range_min_m);
    message.range_max = static_cast<float>(scan.range_max_m);
    message.ranges = scan.ranges_m;
    return message;
}

RosOdometry odometry_message(std::int64_t stamp_ns, const std::string& frame_id, const std::string& child_frame_id,
                             const Pose2& frame_from_child) {
    RosOdometry message;
    message.header = {{stamp_ns}, frame_id};
    message.child_frame_id = child_frame_id;
    message.pose = to_ros_pose(frame_from_child);
    return message;
}

RosPoseStamped pose_message(std::int64_t stamp_ns, const std::string& frame_id, const Pose2& pose) {
    return {{{stamp_ns}, frame_id}, to_ros_pose(pose)};
}

RosTFMessage transform_message(std::int64_t stamp_ns, const std::string& frame_id, const std::string& child_frame_id,
                               const Pose2& frame_from_child) {
    return {{{{{stamp_ns}, frame_id}, child_frame_id, to_ros_pose(frame_from_child)}}};
}

}  // namespace ddtool

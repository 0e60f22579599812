#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "ddtool/robot/sensor_stream.hpp"

namespace ddtool {

/// The time from the first beam of a scan to the last.
double sweep_duration_s(const LaserScan& scan, double time_increment_s);

/// SensorFrame::sweep of a scan whose beams are time_increment_s apart, from the first on, which is measured at the
/// stamp (sensor_msgs/msg/LaserScan). A negative increment: the last beam is measured at the stamp, and the first last.
/// Empty if the increment is 0, and where the pose is unknown at any of the times.
/// \param odom_from_robot the odometry's pose so many seconds after the stamp; nullopt where it is unknown
std::vector<Pose2> sweep_of(const LaserScan& scan, double time_increment_s,
                            const std::function<std::optional<Pose2>(double)>& odom_from_robot);

/// The robot's pose in its frame at the stamp, when beam `beam` of `beams` is measured.
/// \param sweep SensorFrame::sweep, not empty
Pose2 pose_in_sweep(const std::vector<Pose2>& sweep, std::size_t beam, std::size_t beams);

/// The same scan with its beams in the opposite order.
void reverse_beams(LaserScan& scan);

}  // namespace ddtool

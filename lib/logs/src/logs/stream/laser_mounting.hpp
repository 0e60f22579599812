#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <optional>
#include <string>

#include "ddtool/logs/log_stream.hpp"
#include "ddtool/robot/sensor_stream.hpp"
#include "logs/messages/readings.hpp"
#include "logs/stream/no_return.hpp"

namespace ddtool {

/// What the readings of a log mean.
struct RangeRules {
    NoReturns no_returns;
    double range_max_m = 0.0;  ///< instead of what the scans state; 0: what they state
};

/// Puts a logged scan into a frame in the form that SensorFrame requires: in the plane, with normalised ranges. The
/// scan of a lidar that is mounted upside down is mirrored. Returns nullopt if all is well, and otherwise why the scan
/// cannot be used, for example because an angle is not finite.
std::optional<std::string> place_scan(ScanReading reading, const Eigen::Isometry3d& robot_from_laser,
                                      const RangeRules& rules, SensorFrame& frame);

/// Makes a frame of a point cloud: its scan is that of cloud_scan(), with normalised ranges.
void place_cloud(const CloudReading& cloud, const Eigen::Isometry3d& robot_from_lidar, const HeightBand& band,
                 std::size_t beams, const RangeRules& rules, SensorFrame& frame);

/// Whether two poses of a laser on the robot are the same to a millimetre and a milliradian. In logs that give the pose
/// with each scan, it differs in the last digits.
bool is_same_mounting(const Pose2& a, const Pose2& b);

}  // namespace ddtool

#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <string>

#include "ddtool/robot/sensor_stream.hpp"
#include "logs/messages/readings.hpp"

namespace ddtool {

/// Puts a logged scan into a frame as SensorFrame wants it: mounted in the plane, its ranges normalised. The scan of a
/// lidar that is mounted upside down is mirrored. Returns what is wrong with a scan that cannot be used, e.g. angles
/// that are not finite.
std::optional<std::string> place_scan(ScanReading reading, const Eigen::Isometry3d& robot_from_laser,
                                      SensorFrame& frame);

}  // namespace ddtool

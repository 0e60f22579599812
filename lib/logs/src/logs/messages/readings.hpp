#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <string>

#include "ddtool/robot/laser_scan.hpp"

namespace ddtool {

/// Positions further away than this are taken for damaged numbers, whose sums and squares would soon no longer be
/// finite.
inline constexpr double farthest_m = 1e9;

/// A laser scan as it is in a log, for all message types.
struct ScanReading {
    std::string frame_id;
    Eigen::Isometry3d frame_from_scan = Eigen::Isometry3d::Identity();  ///< the scan's own origin, if it has one
    LaserScan scan;                                                     ///< ranges as logged, not yet normalised
    bool has_stamp = true;  ///< false: the message's stamp is 0; the time of recording stands for it
};

/// A pose or transform as it is in a log, for all message types.
struct PoseReading {
    std::int64_t stamp_ns = 0;
    std::string frame_id;
    std::string child_frame_id;  ///< empty where the message type has none
    Eigen::Isometry3d frame_from_child = Eigen::Isometry3d::Identity();
    bool has_rotation = true;  ///< false: the message's quaternion is 0,0,0,0 or no number; the identity stands for it
    bool has_stamp = true;     ///< false: the message's stamp is 0; the time of recording stands for it
};

}  // namespace ddtool

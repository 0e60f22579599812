#pragma once

#include <cstddef>
#include <cstdint>

#include "ddtool/robot/pose2.hpp"
#include "graph/packed_scan.hpp"

namespace ddtool::graph {

/// A scan that entered the filter's map.
struct Node {
    std::int64_t stamp_ns = 0;
    std::size_t scan = 0;  ///< its number among all scans of the run
    Pose2 odom_from_robot;
    double duration_s = 0.0;  ///< since the node before, without pauses
    double degree = 0.0;      ///< the highest degree of degeneracy since the node before
    PackedScan points;
};

}  // namespace ddtool::graph

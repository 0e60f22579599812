#pragma once

#include <filesystem>

#include "graph/pose_graph.hpp"

namespace ddtool::graph {

/// Writes the graph in the text format of g2o (Kümmerle et al. 2011), which GTSAM, Ceres' examples and others read:
/// VERTEX_SE2 for a node, FIX for node 0, EDGE_SE2 for each odometry, match and loop edge with its information (times
/// its weight) in the order xx xy xt yy yt tt. Odometry edges have the calibration applied. Loops of weight 0 are left
/// out. Throws OutputError naming the file.
void write_g2o(const std::filesystem::path& file, const PoseGraph& graph);

/// Reads such a file: its vertices as poses, in the order of their numbers, which must be 0, 1, 2, ...; its edges all
/// as matches; scale and bias are held. Throws Error naming the file and the line.
PoseGraph read_g2o(const std::filesystem::path& file);

}  // namespace ddtool::graph

#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "graph/pose_graph.hpp"
#include "merging/map_side.hpp"

namespace ddtool::merging {

/// Where a window of the newer side is expected.
struct ExpectedWindow {
    std::size_t window = 0;                                ///< of the newer side
    Pose2 pose;                                            ///< older_from_anchor
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();  ///< x, y, theta in the older side's frame
};

/// Edges between the nodes of two sides: each window of the newer side is matched to the nearest ones of the older side
/// by their local maps, as the loops of one drive are (graph::LoopSearch). `from` is a node of the older side, `to` one
/// of the newer. Where the match leaves a direction open, the edge holds nothing along it. Throws MapTooLarge.
std::vector<graph::RelativeEdge> seams(const MapSide& older, const MapSide& newer,
                                       const std::vector<ExpectedWindow>& expected, const RbpfSettings& settings);

/// Edges from single scans of the newer side: each is matched to the whole map of the older side and tied to its
/// nearest node. Scans that the map does not explain, or that lie far from all nodes, have none. \param newer_poses of
/// the newer side's nodes in the older side's frame, right to a few centimetres
std::vector<graph::RelativeEdge> scan_seams(const OccupancyGrid& older_map, const std::vector<Pose2>& older_poses,
                                            const std::vector<maps::MapNode>& newer,
                                            const std::vector<Pose2>& newer_poses, const RbpfSettings& settings);

}  // namespace ddtool::merging

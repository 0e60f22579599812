#pragma once

#include <Eigen/Core>
#include <vector>

#include "graph/pose_graph.hpp"

namespace ddtool::merging {

/// The poses of two sides in one frame, the older side first, and what ties them.
struct Joined {
    std::vector<Pose2> poses;
    std::vector<graph::RelativeEdge> seams;        ///< those that the solution keeps; numbers of nodes in `poses`
    std::size_t dropped = 0;                       ///< seams that contradict all others
    Eigen::Vector3d sd = Eigen::Vector3d::Zero();  ///< how well the seams hold the newer side: m, m, rad; sorted axes
};

/// Moves two sides to where their seams want them. Each side keeps its shape as far as the seams allow: its poses are
/// tied to each other, along its path and where the path comes near itself, by what they are now. The first node stays.
/// \param older poses of the older side
/// \param newer poses of the newer side in the older one's frame, as far as they are known
/// \param seams from older to newer, with their numbers within each side
Joined joined(const std::vector<Pose2>& older, const std::vector<Pose2>& newer, std::vector<graph::RelativeEdge> seams);

}  // namespace ddtool::merging

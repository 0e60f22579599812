#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "graph/node.hpp"
#include "graph/pose_graph.hpp"

namespace ddtool::graph {

/// A pair of stretches that were compared, and what came of it.
struct Loop {
    RelativeEdge edge;
    double agreed = 0.0;
    bool open_along = false;  ///< more than one place fits along one direction, in which the edge holds nothing
    std::string refusal;      ///< empty if the loop is part of the solution
};

/// Finds loops and closes them: in rounds, stretches of the path are matched to older ones that may lie at the same
/// place as far as the present graph knows; what passes the comparison of pairs is solved robustly. The graph then has
/// the accepted loops and their solution.
/// \param graph solved, without loops
/// \return all pairs that were compared, in the order of the newer node
std::vector<Loop> close_loops(PoseGraph& graph, const std::vector<Node>& nodes, const RbpfSettings& settings);

}  // namespace ddtool::graph

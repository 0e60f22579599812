#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "graph/pose_graph.hpp"
#include "graph/solver.hpp"

namespace ddtool::graph {

/// What is tested of a loop edge before it may pull at the graph.
struct Consistency {
    bool within_gate = true;      ///< agrees with the graph as it is without any loop
    std::size_t contradicts = 0;  ///< so many of the loops within the gate
    bool kept = true;
};

/// Compares loop edges with each other, pair by pair, through the graph without them: two loops are consistent if both
/// their errors together are within what the graph's covariance and their own allow (Mangelson et al., "Pairwise
/// consistent measurement set maximization", ICRA 2018, with the joint compatibility of Neira and Tardós 2001 as the
/// measure, so that what the graph already knows counts). Loops that are inconsistent with more than half of the others
/// are dropped, the worst first. Of very many loops, each is compared with the few hundred beside it in the order
/// given. \param graph solved, without loops
std::vector<Consistency> consistency_of(const PoseGraph& graph, std::span<const RelativeEdge> loops);

/// Solves the graph with truncated least squares over its loops by graduated non-convexity (Yang, Antonante, Tzoumas,
/// Carlone, "Graduated non-convexity for robust spatial perception", RA-L 2020). Sets the loops' weights, in the end
/// near 0 or 1.
Solution minimise_robustly(PoseGraph& graph);

}  // namespace ddtool::graph

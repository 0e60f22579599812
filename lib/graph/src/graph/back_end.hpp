#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "ddtool/filter/rbpf.hpp"
#include "ddtool/robot/trajectory.hpp"
#include "graph/loop_edges.hpp"
#include "graph/node.hpp"
#include "graph/pose_graph.hpp"

namespace ddtool::graph {

/// What the back end made of a run.
struct Smoothed {
    Trajectory trajectory;               ///< a pose for every scan
    std::optional<OccupancyGrid> map{};  ///< drawn anew from the nodes' scans; empty if there are none
    /// The mean squared error of the accepted loops on the filter's path, in units of their covariance. On a right path
    /// chance gives 3.
    double loop_error_of_path = 0.0;
    PoseGraph graph{};                           ///< solved
    std::vector<std::int64_t> stamps_ns{};       ///< of the nodes
    std::vector<Eigen::Matrix3d> covariances{};  ///< of the nodes' poses (x, y, theta in the world), node 0 held
    std::vector<Loop> loops{};                   ///< accepted and refused
    std::size_t scan_bytes = 0;                  ///< memory of the nodes' scans
};

/// Keeps the nodes of a run, and at its end goes once more over everything: a pose graph of the nodes is built, loops
/// are closed, and the path and the map are made anew from its solution (docs/graph.md). The same run gives the same
/// bytes. For one thread.
class BackEnd {
public:
    /// \param settings the filter's: how a scan is matched
    explicit BackEnd(const RbpfSettings& settings) : settings_(settings) {}

    /// Adds the next node, as NodeRecorder makes it.
    void add(Node node) { nodes_.push_back(std::move(node)); }

    /// \param path the filter's result, with a pose for every scan of the run; a node behind its end is left out
    /// Throws MapTooLarge, and Error where the graph cannot be solved.
    [[nodiscard]] Smoothed finish(const Trajectory& path) const;

private:
    RbpfSettings settings_;
    std::vector<Node> nodes_;
};

}  // namespace ddtool::graph

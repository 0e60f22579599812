#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "ddtool/filter/rbpf.hpp"
#include "ddtool/filter/update.hpp"
#include "ddtool/robot/sensor_stream.hpp"
#include "ddtool/robot/trajectory.hpp"
#include "graph/local_track.hpp"
#include "graph/loop_edges.hpp"
#include "graph/pose_graph.hpp"

namespace ddtool::graph {

/// What the back end made of a run.
struct Smoothed {
    Trajectory trajectory;  ///< a pose for every scan: of the graph, or of the filter where the loops agree with it
    std::optional<OccupancyGrid> map{};  ///< drawn anew from the nodes' scans; empty where the path is the filter's
    /// The mean squared error of the accepted loops on the filter's path, in units of their covariance. On a right path
    /// chance gives 3; the filter's path is kept up to that.
    double loop_error_of_path = 0.0;
    PoseGraph graph{};                           ///< solved
    std::vector<std::int64_t> stamps_ns{};       ///< of the nodes
    std::vector<Eigen::Matrix3d> covariances{};  ///< of the nodes' poses (x, y, theta in the world), node 0 held
    std::vector<Loop> loops{};                   ///< accepted and refused
    std::size_t scan_bytes = 0;                  ///< memory of the nodes' scans
};

/// Keeps the scans that enter the filter's map, and at the end of the run goes once more over everything: a pose graph
/// of these scans is built, loops are closed, and the path and the map are made anew from its solution
/// (docs/graph.md). The same run gives the same bytes. For one thread.
class BackEnd {
public:
    /// \param settings the filter's: when a scan enters the map, and how it is matched
    explicit BackEnd(const RbpfSettings& settings) : settings_(settings) {}

    /// Call this after the filter has processed the frame. `update` is empty where the frame caused no update.
    void add(const SensorFrame& frame, const std::optional<Update>& update);

    /// \param path the filter's result, with a pose for every frame that was added; a frame behind its end is left out
    /// Throws MapTooLarge, and Error where the graph cannot be solved.
    [[nodiscard]] Smoothed finish(const Trajectory& path) const;

private:
    RbpfSettings settings_;
    std::vector<Node> nodes_;
    std::size_t scans_ = 0;
    double degree_ = 0.0;  ///< the highest since the last node
    std::int64_t stamp_ns_ = 0;
    double duration_s_ = 0.0;  ///< since the last node
};

}  // namespace ddtool::graph

#include "graph/back_end.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>

#include "base/squared.hpp"
#include "ddtool/filter/learnt_odometry.hpp"
#include "ddtool/filter/scan_insertion.hpp"
#include "ddtool/filter/scan_noise.hpp"
#include "filter/pose_covariance.hpp"
#include "graph/marginals.hpp"
#include "graph/path_steps.hpp"
#include "graph/robust.hpp"
#include "graph/solver.hpp"

namespace ddtool::graph {
namespace {

/// How far back on the way the match edges of a node reach. A lidar still sees there much of what it sees here, and a
/// chain of the shortest edges alone would drift far more than scans do that are matched to one map.
constexpr std::array edge_ways_m{0.0, 1.0, 3.0, 9.0};

/// Matches at the end of the map err by one or two parts in a thousand of the way, all alike in one kind of
/// surroundings (docs/reports/2026-12-01-graph.md).
constexpr double match_stretch_sd = 0.0015;

/// Along every direction the smaller one of the two.
Eigen::Matrix3d smaller_information(const Eigen::Matrix3d& a, const Eigen::Matrix3d& b) {
    constexpr double least_information = 1e-4;  // so that a direction without information can be inverted
    const Eigen::Matrix3d base = b + least_information * Eigen::Matrix3d::Identity();
    const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::Matrix3d> axes(a, base);
    const Eigen::Matrix3d basis = base * axes.eigenvectors();
    return basis * axes.eigenvalues().cwiseMax(0.0).cwiseMin(1.0).asDiagonal() * basis.transpose();
}

/// A step's information ties its node to several ones before, in equal parts, since the scan was matched to a map of
/// all of them. An edge holds no more than every step on the way there did, so that a wall that has just come into
/// sight says nothing about the nodes before it did.
void add_matches(PoseGraph& graph, const std::vector<PathStep>& steps, std::size_t node) {
    const PathStep& step = steps[node];
    if (step.information.trace() <= 0.0) {
        return;
    }
    const Eigen::Matrix3d to_world = turned_about_z(step.pose.theta_rad);
    std::vector<RelativeEdge> edges;
    std::size_t back = node - 1;
    double way_m = distance_m(steps[back].pose, step.pose);
    Eigen::Matrix3d held = step.information;
    for (const double reach_m : edge_ways_m) {
        while (back > 0 && way_m < reach_m) {
            held = smaller_information(held, steps[back].information);
            --back;
            way_m += distance_m(steps[back].pose, steps[back + 1].pose);
        }
        if (way_m >= reach_m && (edges.empty() || edges.back().from != back)) {
            edges.push_back({.from = back,
                             .to = node,
                             .measured = between(steps[back].pose, step.pose),
                             .information = to_world.transpose() * held * to_world});
        }
    }
    for (RelativeEdge& edge : edges) {
        edge.information /= static_cast<double>(edges.size());
    }
    graph.matches.insert(graph.matches.end(), edges.begin(), edges.end());
}

PoseGraph graph_of(const std::vector<Node>& nodes, const PathSteps& path) {
    PoseGraph graph;
    graph.calibration.scale_sd = OdometryLearning::scale_sd;
    graph.calibration.bias_sd_rad_per_s = OdometryLearning::bias_sd_rad_per_s;
    graph.match_stretch.sd = match_stretch_sd;
    for (std::size_t node = 0; node < nodes.size(); ++node) {
        const PathStep& step = path.steps[node];
        graph.poses.push_back(step.pose);
        if (node == 0) {
            continue;
        }
        const MotionSigmas random = motion_sigmas(step.odometry, path.noise);
        // Added so that a node reached without any motion of the odometry is not fixed to the one before.
        constexpr double least_m = 1e-3;
        constexpr double least_rad = 5e-4;
        const double factor = OdometryLearning::caution * std::sqrt(step.doubt);
        graph.odometry.push_back({.from = node - 1,
                                  .motion = step.odometry,
                                  .duration_s = nodes[node].duration_s,
                                  .sigmas = {factor * random.x_m + least_m, factor * random.y_m + least_m,
                                             factor * random.theta_rad + least_rad}});
        add_matches(graph, path.steps, node);
    }
    return graph;
}

/// Between two nodes the path keeps the shape that the filter gave it, and the correction by the second is spread over
/// the way there.
Trajectory corrected(const Trajectory& path, const std::vector<Node>& nodes, const std::vector<Pose2>& poses) {
    Trajectory result = path;
    std::vector<double> way(path.size(), 0.0);
    for (std::size_t scan = 1; scan < path.size(); ++scan) {
        way[scan] = way[scan - 1] + way_for_scans_m(between(path[scan - 1].pose, path[scan].pose));
    }
    std::size_t node = 0;
    for (std::size_t scan = 0; scan < path.size(); ++scan) {
        while (node + 1 < nodes.size() && nodes[node + 1].scan <= scan) {
            ++node;
        }
        const std::size_t at = nodes[node].scan;
        const Pose2 by_filter = poses[node] * between(path[at].pose, path[scan].pose);
        result[scan].pose = by_filter;
        if (node + 1 < nodes.size()) {
            const std::size_t next = nodes[node + 1].scan;
            const double whole = way[next] - way[at];
            const double share = whole > 0.0 ? (way[scan] - way[at]) / whole : 0.0;
            const Pose2 end = poses[node] * between(path[at].pose, path[next].pose);
            result[scan].pose = by_filter * interpolate({}, between(end, poses[node + 1]), share);
        }
    }
    return result;
}

OccupancyGrid drawn(const std::vector<Node>& nodes, const std::vector<Pose2>& poses,
                    const OccupancySettings& settings) {
    OccupancyGrid map(settings);
    ScanInserter inserter;
    for (std::size_t node = 0; node < nodes.size(); ++node) {
        inserter.insert(map, nodes[node].points.unpacked(), poses[node]);
    }
    return map;
}

/// The mean squared error of the accepted loops at the given poses, in units of their covariance.
double mean_loop_error(PoseGraph graph, const std::vector<Pose2>& poses) {
    graph.poses = poses;
    double sum = 0.0;
    double weights = 0.0;
    for (const RelativeEdge& loop : graph.loops) {
        sum += loop.weight * squared_error(graph, loop);
        weights += loop.weight;
    }
    return weights > 0.0 ? sum / weights : 0.0;
}

}  // namespace

Smoothed BackEnd::finish(const Trajectory& path) const {
    Smoothed result{.trajectory = path};
    std::vector<Node> nodes = nodes_;
    std::erase_if(nodes, [&](const Node& node) { return node.scan >= path.size(); });
    if (nodes.empty()) {
        return result;
    }
    std::vector<Pose2> by_filter;
    for (const Node& node : nodes) {
        by_filter.push_back(path[node.scan].pose);
        result.stamps_ns.push_back(node.stamp_ns);
        result.scan_bytes += node.points.bytes();
    }
    result.graph = graph_of(nodes, path_steps(nodes, by_filter, settings_));
    minimise(result.graph);
    result.loops = close_loops(result.graph, nodes, settings_);
    result.covariances = Marginals(result.graph).of_nodes();
    result.loop_error_of_path = mean_loop_error(result.graph, by_filter);
    result.trajectory = corrected(path, nodes, result.graph.poses);
    result.map = drawn(nodes, result.graph.poses, settings_.grid);
    return result;
}

}  // namespace ddtool::graph

#include "graph/back_end.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "base/squared.hpp"
#include "ddtool/filter/learnt_odometry.hpp"
#include "ddtool/filter/scan_insertion.hpp"
#include "filter/pose_covariance.hpp"
#include "graph/marginals.hpp"
#include "graph/robust.hpp"
#include "graph/solver.hpp"

namespace ddtool::graph {
namespace {

/// What chance gives a loop on a right path: the mean of chi-square with three degrees of freedom.
constexpr double usual_loop_error = 3.0;

Eigen::Matrix3d information_in_local(const LocalStep& step) {
    const Eigen::Matrix3d to_local = turned_about_z(step.pose.theta_rad);
    return to_local * step.information * to_local.transpose();
}

/// How far back on the way the second match edge of a node reaches. A lidar still sees there much of what it sees here.
constexpr double long_edge_m = 5.0;

/// Half of a match's information ties a node to the one before, half to one some metres back, since it was matched to a
/// map of all of them: a chain of the short edges alone would drift far more than scans matched to one map do. The long
/// edge holds no more than every match on the way there did, so that a wall that has just come into sight says nothing
/// about the node before it did.
void add_matches(PoseGraph& graph, const LocalTrack& track, std::size_t node) {
    const LocalStep& step = track.steps[node];
    if (step.information.trace() <= 0.0) {
        return;
    }
    graph.matches.push_back(
        {.from = node - 1, .to = node, .measured = step.matched, .information = 0.5 * step.information});
    std::size_t back = node - 1;
    double way_m = distance_m(track.steps[back].pose, step.pose);
    constexpr double least_information = 1e-4;  // so that a direction without information can be inverted
    const Eigen::Matrix3d least = least_information * Eigen::Matrix3d::Identity();
    Eigen::Matrix3d sum = (information_in_local(step) + least).inverse();
    while (back > 0 && way_m < long_edge_m) {
        sum += (information_in_local(track.steps[back]) + least).inverse();
        --back;
        way_m += distance_m(track.steps[back].pose, track.steps[back + 1].pose);
    }
    if (back + 1 == node) {
        return;
    }
    const Pose2 measured = track.steps[node - 1].pose * step.matched;
    const Eigen::Matrix3d to_local = turned_about_z(measured.theta_rad);
    graph.matches.push_back({.from = back,
                             .to = node,
                             .measured = between(track.steps[back].pose, measured),
                             .information = 0.5 * to_local.transpose() * sum.inverse() * to_local});
}

PoseGraph graph_of(const std::vector<Node>& nodes, const LocalTrack& track, const Pose2& start) {
    PoseGraph graph;
    graph.calibration.scale_sd = OdometryLearning::scale_sd;
    graph.calibration.bias_sd_rad_per_s = OdometryLearning::bias_sd_rad_per_s;
    for (std::size_t node = 0; node < nodes.size(); ++node) {
        const LocalStep& step = track.steps[node];
        graph.poses.push_back(start * step.pose);
        if (node == 0) {
            continue;
        }
        const MotionSigmas random = motion_sigmas(step.odometry, track.noise);
        // Added so that a node reached without any motion of the odometry is not fixed to the one before.
        constexpr double least_m = 1e-3;
        constexpr double least_rad = 5e-4;
        const double factor = OdometryLearning::caution * std::sqrt(step.doubt);
        graph.odometry.push_back({.from = node - 1,
                                  .motion = step.odometry,
                                  .duration_s = nodes[node].duration_s,
                                  .sigmas = {factor * random.x_m + least_m, factor * random.y_m + least_m,
                                             factor * random.theta_rad + least_rad}});
        add_matches(graph, track, node);
    }
    return graph;
}

double motion_of(const Pose2& a, const Pose2& b) {
    constexpr double metres_per_radian = 0.3;
    const Pose2 motion = between(a, b);
    return std::hypot(motion.x_m, motion.y_m) + metres_per_radian * std::abs(motion.theta_rad);
}

/// Between two nodes the path keeps the shape that the filter gave it, and the correction by the second is spread over
/// the way there.
Trajectory corrected(const Trajectory& path, const std::vector<Node>& nodes, const std::vector<Pose2>& poses) {
    Trajectory result = path;
    std::vector<double> way(path.size(), 0.0);
    for (std::size_t scan = 1; scan < path.size(); ++scan) {
        way[scan] = way[scan - 1] + motion_of(path[scan - 1].pose, path[scan].pose);
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
    result.graph = graph_of(nodes, local_track(nodes, by_filter, settings_), by_filter.front());
    minimise(result.graph);
    result.loops = close_loops(result.graph, nodes, settings_);
    result.covariances = Marginals(result.graph).of_nodes();
    result.loop_error_of_path = mean_loop_error(result.graph, by_filter);
    if (result.loop_error_of_path > usual_loop_error) {
        result.trajectory = corrected(path, nodes, result.graph.poses);
        result.map = drawn(nodes, result.graph.poses, settings_.grid);
    }
    return result;
}

}  // namespace ddtool::graph

#include "merging/joint_graph.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>

#include "base/squared.hpp"
#include "filter/pose_covariance.hpp"
#include "graph/robust.hpp"
#include "graph/solver.hpp"
#include "graph/stretches.hpp"

namespace ddtool::merging {
namespace {

/// How far a map is bent from one node to the next: a part that is always there, and parts of way and turn.
constexpr double least_m = 0.002;
constexpr double per_m = 0.01;
constexpr double least_rad = 0.0005;
constexpr double rad_per_m = 0.002;
constexpr double per_rad = 0.005;
/// Where a path comes near itself, its scans were matched to the same walls.
constexpr double near_itself_m = 3.0;
constexpr double near_itself_way_m = 20.0;
constexpr double near_itself_sd_m = 0.02;
constexpr double near_itself_sd_rad = 0.005;
/// Seams with less weight than this are given up.
constexpr double least_weight = 0.5;

graph::RelativeEdge tie(std::size_t from, std::size_t to, const Pose2& measured, double sd_m, double sd_rad) {
    graph::RelativeEdge edge{.from = from, .to = to, .measured = measured};
    edge.information.diagonal() << 1.0 / squared(sd_m), 1.0 / squared(sd_m), 1.0 / squared(sd_rad);
    return edge;
}

/// Ties the poses of one side, whose numbers begin at `first`, to each other as they are.
void keep_shape(graph::PoseGraph& graph, const std::vector<Pose2>& side, std::size_t first) {
    for (std::size_t node = 1; node < side.size(); ++node) {
        const Pose2 motion = between(side[node - 1], side[node]);
        const double way_m = std::hypot(motion.x_m, motion.y_m);
        const double turn_rad = std::abs(motion.theta_rad);
        graph.matches.push_back(tie(first + node - 1, first + node, motion, least_m + per_m * way_m,
                                    least_rad + rad_per_m * way_m + per_rad * turn_rad));
    }
    const std::vector<graph::Stretch> stretches = graph::stretches_of(side);
    for (std::size_t later = 1; later < stretches.size(); ++later) {
        for (std::size_t earlier = 0; earlier < later; ++earlier) {
            const Pose2& from = side[stretches[earlier].anchor];
            const Pose2& to = side[stretches[later].anchor];
            if (stretches[later].way_m - stretches[earlier].way_m > near_itself_way_m &&
                distance_m(from, to) < near_itself_m) {
                graph.matches.push_back(tie(first + stretches[earlier].anchor, first + stretches[later].anchor,
                                            between(from, to), near_itself_sd_m, near_itself_sd_rad));
            }
        }
    }
}

/// How well all seams together hold the newer side, as a rigid body, at the middle of the seams.
Eigen::Vector3d held_by(const std::vector<Pose2>& poses, const std::vector<graph::RelativeEdge>& seams) {
    Point2 middle;
    for (const graph::RelativeEdge& seam : seams) {
        middle.x_m += poses[seam.to].x_m / static_cast<double>(seams.size());
        middle.y_m += poses[seam.to].y_m / static_cast<double>(seams.size());
    }
    Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
    for (const graph::RelativeEdge& seam : seams) {
        const Pose2& at = poses[seam.to];
        Eigen::Matrix3d by_body = Eigen::Matrix3d::Identity();
        by_body(0, 2) = -(at.y_m - middle.y_m);
        by_body(1, 2) = at.x_m - middle.x_m;
        const Eigen::Matrix3d to_map = turned_about_z(at.theta_rad);
        sum += by_body.transpose() * to_map * seam.information * to_map.transpose() * by_body;
    }
    constexpr double least_information = 1e-6;
    const Eigen::Matrix3d covariance = (sum + least_information * Eigen::Matrix3d::Identity()).inverse();
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(covariance.topLeftCorner<2, 2>());
    return {std::sqrt(axes.eigenvalues()(0)), std::sqrt(axes.eigenvalues()(1)), std::sqrt(covariance(2, 2))};
}

}  // namespace

Joined joined(const std::vector<Pose2>& older, const std::vector<Pose2>& newer,
              std::vector<graph::RelativeEdge> seams) {
    graph::PoseGraph graph;
    graph.calibration.scale_sd = graph.calibration.bias_sd_rad_per_s = 0.0;
    graph.poses = older;
    graph.poses.insert(graph.poses.end(), newer.begin(), newer.end());
    keep_shape(graph, older, 0);
    keep_shape(graph, newer, older.size());
    for (graph::RelativeEdge& seam : seams) {
        seam.to += older.size();
    }
    graph.loops = std::move(seams);
    graph::minimise_robustly(graph);
    Joined result{.poses = std::move(graph.poses), .seams = {}};
    for (const graph::RelativeEdge& seam : graph.loops) {
        if (seam.weight >= least_weight) {
            result.seams.push_back(seam);
        } else {
            ++result.dropped;
        }
    }
    constexpr double unknown = std::numeric_limits<double>::infinity();
    result.sd = result.seams.empty() ? Eigen::Vector3d(unknown, unknown, unknown) : held_by(result.poses, result.seams);
    return result;
}

}  // namespace ddtool::merging

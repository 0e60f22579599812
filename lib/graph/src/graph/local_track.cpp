#include "graph/local_track.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <utility>

#include "base/squared.hpp"
#include "ddtool/filter/information_fusion.hpp"
#include "ddtool/filter/learnt_odometry.hpp"
#include "filter/pose_covariance.hpp"

namespace ddtool::graph {
namespace {

/// After this way the map is replaced by its successor, so that it holds the last one to two times as much.
constexpr double map_length_m = 10.0;
/// Standard deviations of a match's start. Wide beside any step's error, so that the scan decides what it can.
constexpr PosePrior start_prior{.sigma_along_m = 0.2, .sigma_across_m = 0.2, .sigma_turn_rad = 0.1};
/// Odometry farther from the match than so many deviations of both together counts as less sure.
constexpr double most_deviations = 3.0;

class Tracker {
public:
    Tracker(const RbpfSettings& settings)
        : settings_(settings),
          matcher_(settings.matcher, settings.grid.cell_size_m),
          map_(settings.grid),
          next_map_(settings.grid) {}

    void start(const Node& node) { enter(node.points.unpacked(), {}); }

    LocalStep step(const Node& before, const Node& node, const Pose2& expected_start) {
        LocalStep step;
        step.odometry = between(before.odom_from_robot, node.odom_from_robot);
        const Pose2 odometry = pose_ * learnt_.expected(step.odometry, node.duration_s);
        const Eigen::Matrix3d odometry_information =
            predicted_covariance(Eigen::Matrix3d::Zero(), pose_, step.odometry,
                                 learnt_.sigmas(step.odometry, node.duration_s))
                .inverse();
        const ScanPoints points = node.points.unpacked();
        const Pose2 start = pose_ * expected_start;
        const ScanMatch found =
            matcher_.match(map_, MatchPoints(points, settings_.grid.cell_size_m), start, start_prior);
        Eigen::Matrix3d match = Eigen::Matrix3d::Zero();
        Eigen::Vector3d apart = Eigen::Vector3d::Zero();
        if (found.accepted()) {
            match = credible_information(found.information, odometry_information, InformationFusion::normal_error_rad,
                                         node.degree);
            apart = offset(odometry, moved_by(found.pose, offset_without_prior(found, start, start_prior)));
            step.doubt = std::max(1.0, contradiction(match, odometry_information, apart) / squared(most_deviations));
        }
        const Eigen::Matrix3d trusted = odometry_information / step.doubt;
        const Pose2 fused = moved_by(odometry, (match + trusted).ldlt().solve(match * apart));
        // Along what the scan does not hold, where the match lies does not matter. To keep the numbers small it is put
        // where the fused pose is: f = o + (M + O)^-1 M (m - o) gives M (m - f) = O (f - o).
        const Eigen::Matrix3d whole = match + 1e-6 * trusted;
        const Pose2 measured = moved_by(fused, whole.ldlt().solve(trusted * offset(odometry, fused)));
        step.matched = between(pose_, measured);
        const Eigen::Matrix3d to_world = turned_about_z(measured.theta_rad);
        step.information = to_world.transpose() * match * to_world;
        step.pose = fused;
        learn(step, node.duration_s, found.accepted() ? found.information : Eigen::Matrix3d::Zero());
        enter(points, step.pose);
        return step;
    }

    [[nodiscard]] MotionNoise noise() const { return learnt_.noise(); }

private:
    void learn(const LocalStep& step, double duration_s, const Eigen::Matrix3d& information) {
        poses_.push_back(step.pose);
        const Eigen::Matrix3d to_world = turned_about_z(step.pose.theta_rad);
        learnt_.learn({.odometry = step.odometry,
                       .duration_s = duration_s,
                       .information = to_world.transpose() * information * to_world,
                       .pose_before = [this](std::size_t updates) {
                           return poses_[poses_.size() - 1 - std::min(updates, poses_.size() - 1)];
                       }});
    }

    void enter(const ScanPoints& points, const Pose2& pose) {
        if (poses_.empty()) {
            poses_.push_back(pose);
        }
        length_m_ += distance_m(pose_, pose);
        if (length_m_ > map_length_m) {
            map_ = std::exchange(next_map_, OccupancyGrid(settings_.grid));
            length_m_ = 0.0;
        }
        inserter_.insert(map_, points, pose);
        inserter_.insert(next_map_, points, pose);
        pose_ = pose;
    }

    const RbpfSettings& settings_;
    ScanMatcher matcher_;
    ScanInserter inserter_;
    OccupancyGrid map_;
    OccupancyGrid next_map_;
    LearntOdometry learnt_;
    std::vector<Pose2> poses_;
    Pose2 pose_;
    double length_m_ = 0.0;
};

}  // namespace

LocalTrack local_track(const std::vector<Node>& nodes, const std::vector<Pose2>& path, const RbpfSettings& settings) {
    LocalTrack track;
    if (nodes.empty()) {
        return track;
    }
    Tracker tracker(settings);
    tracker.start(nodes.front());
    track.steps.emplace_back();
    for (std::size_t node = 1; node < nodes.size(); ++node) {
        track.steps.push_back(tracker.step(nodes[node - 1], nodes[node], between(path[node - 1], path[node])));
    }
    track.noise = tracker.noise();
    return track;
}

}  // namespace ddtool::graph

#include "graph/path_steps.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <utility>

#include "base/squared.hpp"
#include "ddtool/filter/information_fusion.hpp"
#include "ddtool/filter/learnt_odometry.hpp"
#include "ddtool/filter/scan_noise.hpp"
#include "filter/pose_covariance.hpp"
#include "graph/clear_fall.hpp"

namespace ddtool::graph {
namespace {

/// After this way the map is replaced by its successor, so that it holds the last one to two times as much.
constexpr double map_length_m = 10.0;
/// Standard deviations of a match's start. Wide beside any step's error, so that the scan decides what it can.
constexpr PosePrior start_prior{.sigma_along_m = 0.2, .sigma_across_m = 0.2, .sigma_turn_rad = 0.1};
/// Poses farther apart than so many deviations contradict each other.
constexpr double most_deviations = 3.0;
/// The share of a match's information that is its own: scans that are matched to one map have the map's errors in
/// common. Chosen so that the covariances of simulated drives come out right (docs/graph.md).
constexpr double independent_share = 0.25;
/// A scan whose score is below this share of the usual one fits badly.
constexpr double usual_score_share = 0.8;

/// Adds d d' to the covariance that belongs to the information (Sherman and Morrison).
void loosen(Eigen::Matrix3d& information, const Eigen::Vector3d& d) {
    const Eigen::Vector3d image = information * d;
    information -= image * image.transpose() / (1.0 + d.dot(image));
}

class PathJudge {
public:
    explicit PathJudge(const RbpfSettings& settings)
        : settings_(settings),
          matcher_(settings.matcher, settings.grid.cell_size_m),
          map_(settings.grid),
          next_map_(settings.grid) {}

    PathStep start(const Node& node, const Pose2& pose) {
        poses_.push_back(pose);
        enter(node.points.unpacked(), pose);
        return {.pose = pose, .odometry = {}};
    }

    PathStep step(const Node& before, const Node& node, const Pose2& pose) {
        PathStep step{.pose = pose, .odometry = between(before.odom_from_robot, node.odom_from_robot)};
        const ScanPoints points = node.points.unpacked();
        judge(step, node, MatchPoints(points, settings_.grid.cell_size_m));
        learn(step, node.duration_s);
        enter(points, pose);
        return step;
    }

    [[nodiscard]] MotionNoise noise() const { return learnt_.noise(); }

private:
    void judge(PathStep& step, const Node& node, const MatchPoints& points) {
        const Pose2& before = poses_.back();
        const Pose2 odometry = before * learnt_.expected(step.odometry, node.duration_s);
        const Eigen::Matrix3d odometry_information =
            predicted_covariance(Eigen::Matrix3d::Zero(), before, step.odometry,
                                 learnt_.sigmas(step.odometry, node.duration_s))
                .inverse();
        const ScanMatch best = matcher_.match_directly(map_, points, step.pose, start_prior);
        if (!best.accepted()) {
            return;
        }
        const double factor = independent_share * noise_.information_factor(settings_.matcher.beam_sigma_m);
        noise_.learn(best.misfit_m2);
        step.information = credible_information(factor * best.information, odometry_information,
                                                InformationFusion::normal_error_rad, node.degree);
        score_sum_ += best.score;
        scores_ += 1.0;
        const Eigen::Vector3d from_odometry = offset(odometry, step.pose);
        step.doubt = std::max(
            1.0, contradiction(step.information, odometry_information, from_odometry) / squared(most_deviations));
        if (step.doubt > 1.0 && !is_borne_out(best, points, odometry, step.pose)) {
            loosen(step.information, from_odometry);
        }
        const Pose2 alone = moved_by(best.pose, offset_without_prior(best, step.pose, start_prior));
        const Eigen::Vector3d from_best = offset(alone, step.pose);
        if (from_best.dot(step.information * from_best) > squared(most_deviations)) {
            loosen(step.information, from_best);
        }
    }

    /// Whether the map of the last metres shows that the robot came to `pose` and not to where the odometry says.
    bool is_borne_out(const ScanMatch& best, const MatchPoints& points, const Pose2& odometry, const Pose2& pose) {
        const auto likelihood = [&](const Pose2& at) { return matcher_.evaluate(map_, points, at).log_likelihood; };
        return best.score * scores_ >= usual_score_share * score_sum_ &&
               likelihood(pose) >= likelihood(odometry) + clear_fall;
    }

    void learn(const PathStep& step, double duration_s) {
        poses_.push_back(step.pose);
        const Eigen::Matrix3d to_world = turned_about_z(step.pose.theta_rad);
        learnt_.learn({.odometry = step.odometry,
                       .duration_s = duration_s,
                       .information = to_world.transpose() * step.information * to_world,
                       .pose_before = [this](std::size_t updates) {
                           return poses_[poses_.size() - 1 - std::min(updates, poses_.size() - 1)];
                       }});
    }

    void enter(const ScanPoints& points, const Pose2& pose) {
        if (poses_.size() > 1) {
            length_m_ += distance_m(poses_[poses_.size() - 2], pose);
        }
        if (length_m_ > map_length_m) {
            map_ = std::exchange(next_map_, OccupancyGrid(settings_.grid));
            length_m_ = 0.0;
        }
        inserter_.insert(map_, points, pose);
        inserter_.insert(next_map_, points, pose);
    }

    const RbpfSettings& settings_;
    ScanMatcher matcher_;
    ScanInserter inserter_;
    OccupancyGrid map_;
    OccupancyGrid next_map_;
    LearntOdometry learnt_;
    ScanNoise noise_;
    double score_sum_ = 0.0;
    double scores_ = 0.0;  ///< how many
    std::vector<Pose2> poses_;
    double length_m_ = 0.0;
};

}  // namespace

PathSteps path_steps(const std::vector<Node>& nodes, const std::vector<Pose2>& path, const RbpfSettings& settings) {
    PathSteps result;
    if (nodes.empty()) {
        return result;
    }
    PathJudge judge(settings);
    result.steps.push_back(judge.start(nodes.front(), path.front()));
    for (std::size_t node = 1; node < nodes.size(); ++node) {
        result.steps.push_back(judge.step(nodes[node - 1], nodes[node], path[node]));
    }
    result.noise = judge.noise();
    return result;
}

}  // namespace ddtool::graph

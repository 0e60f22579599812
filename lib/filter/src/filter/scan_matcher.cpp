#include "ddtool/filter/scan_matcher.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>

#include "base/squared.hpp"
#include "filter/beam_sums.hpp"
#include "filter/pose_covariance.hpp"

namespace ddtool {
namespace {

/// Gauss-Newton has converged when a step is smaller than this, which is a fiftieth of a cell of the default size.
constexpr double settled_m = 1e-3;
constexpr double settled_rad = 5e-4;

BeamArrays arrays_of(const MatchPoints& points, const Residuals& residuals) {
    return {points.x.data(),
            points.y.data(),
            residuals.x.data(),
            residuals.y.data(),
            residuals.normal_x.data(),
            residuals.normal_y.data(),
            residuals.along_weight.data(),
            residuals.found.data(),
            residuals.known.data()};
}

}  // namespace

Eigen::Matrix3d information_of(const PosePrior& prior, double theta_rad) {
    const Eigen::Matrix3d world_from_robot = turned_about_z(theta_rad);
    const Eigen::Vector3d sigma(prior.sigma_along_m, prior.sigma_across_m, prior.sigma_turn_rad);
    return world_from_robot * sigma.cwiseAbs2().cwiseInverse().asDiagonal() * world_from_robot.transpose();
}

ScanMatcher::ScanMatcher(const ScanMatcherSettings& settings, double cell_size_m)
    : settings_(settings),
      cell_size_m_(cell_size_m),
      inverse_reach2_(static_cast<float>(squared(cell_size_m / settings.reach_m))),
      surfaces_(cell_size_m) {}

ScanMatcher::Normal ScanMatcher::normal_equations(const MatchPoints& points, const Pose2& pose) const {
    Sums sums{};
    add_normal_equations(arrays_of(points, surfaces_.residuals()), points.x.size(),
                         static_cast<float>(std::cos(pose.theta_rad)), static_cast<float>(std::sin(pose.theta_rad)),
                         inverse_reach2_, sums);
    // Converts from cells to metres, and from squared residuals to information.
    const double per_m2 = 1.0 / squared(settings_.beam_sigma_m);
    const double m = cell_size_m_;
    Normal normal;
    normal.match.pose = pose;
    normal.match.information << sums[xx], sums[xy], m * sums[xt],  //
        sums[xy], sums[yy], m * sums[yt],                          //
        m * sums[xt], m * sums[yt], m * m * sums[tt];
    normal.match.information *= per_m2;
    normal.match.score = sums[total_score] / static_cast<double>(std::max<std::size_t>(points.beams, 1));
    normal.match.misfit_m2 = sums[total_weight] > 0.0 ? m * m * sums[weighted_square] / sums[total_weight] : 0.0;
    normal.gradient = per_m2 * m * Eigen::Vector3d(sums[gx], sums[gy], m * sums[gt]);
    return normal;
}

double ScanMatcher::log_likelihood(const MatchPoints& points) const {
    const double inverse = 0.5 * squared(cell_size_m_ / settings_.beam_sigma_m);
    const double miss = 0.5 * squared(settings_.reach_m / settings_.beam_sigma_m);
    LogLikelihood result;
    add_log_likelihoods(arrays_of(points, surfaces_.residuals()), points.x.size(), static_cast<float>(inverse),
                        static_cast<float>(miss), result);
    // If all beams end in ground that was never observed, the scan says nothing about the pose, and each beam counts as
    // a miss.
    const double mean = result.known_beams > 0.0 ? result.sum / result.known_beams : -miss;
    return mean * static_cast<double>(points.beams);
}

ScanMatch ScanMatcher::evaluate(const OccupancyGrid& grid, const MatchPoints& points, const Pose2& pose) {
    surfaces_.begin(points);
    return evaluated(grid, points, pose);
}

ScanMatch ScanMatcher::evaluated(const OccupancyGrid& grid, const MatchPoints& points, const Pose2& pose) {
    surfaces_.find(grid, points, pose, MeasuredAcross::map_lines);
    ScanMatch match = normal_equations(points, pose).match;
    match.log_likelihood = log_likelihood(points);
    return match;
}

/// The last step is so small that the scan is not evaluated again after it: score, information and likelihood are those
/// of the pose before it. The step itself is taken. Without it every pose would stay slightly too near to its
/// prediction, which adds up over a run.
ScanMatch ScanMatcher::refine(const OccupancyGrid& grid, const MatchPoints& points, const Pose2& start,
                              const Pose2& predicted, const Eigen::Matrix3d& prior_information) {
    Pose2 pose = start;
    // The first step starts from the prediction, where many beams have another nearest point than in the end, so that
    // lines would be fitted in vain.
    bool with_lines = false;
    for (int iteration = 0; iteration < settings_.max_iterations; ++iteration) {
        surfaces_.find(grid, points, pose, with_lines ? MeasuredAcross::map_lines : MeasuredAcross::scan_surfaces);
        Normal normal = normal_equations(points, pose);
        const Eigen::Matrix3d system = normal.match.information + prior_information;
        const Eigen::Vector3d step =
            -system.ldlt().solve(normal.gradient + prior_information * offset(predicted, pose));
        pose = moved_by(pose, step);
        if (with_lines && step.head<2>().norm() < settled_m && std::abs(step.z()) < settled_rad) {
            normal.match.log_likelihood = log_likelihood(points);
            normal.match.pose = pose;
            return normal.match;
        }
        with_lines = true;
    }
    return evaluated(grid, points, pose);
}

Pose2 ScanMatcher::search(const OccupancyGrid& grid, const MatchPoints& points, const Pose2& initial,
                          SearchOrder order) {
    surfaces_.begin(points);
    Pose2 best = initial;
    double best_score = scored(grid, points, initial, search_stride);
    const auto consider = [&](const Pose2& pose) {
        const double pose_score = scored(grid, points, pose, search_stride);
        if (pose_score > best_score) {
            best_score = pose_score;
            best = pose;
        }
    };
    constexpr int turn_steps = 10;
    constexpr int distance_steps = 3;
    const auto consider_headings = [&](const Pose2& centre, double scale) {
        for (int turn = -turn_steps; turn <= turn_steps; ++turn) {
            const double angle = scale * settings_.search_turn_rad * turn / turn_steps;
            consider({centre.x_m, centre.y_m, wrap_angle(centre.theta_rad + angle)});
        }
    };
    const auto for_each_place = [&](const Pose2& centre, double scale, const auto& look) {
        const double step_m = scale * settings_.search_distance_m / distance_steps;
        for (int x = -distance_steps; x <= distance_steps; ++x) {
            for (int y = -distance_steps; y <= distance_steps; ++y) {
                look(Pose2{centre.x_m + x * step_m, centre.y_m + y * step_m, centre.theta_rad});
            }
        }
    };
    if (order == SearchOrder::all_pairs) {
        for_each_place(initial, 1.0, [&](const Pose2& place) { consider_headings(place, 1.0); });
    }
    // Each round tries headings first and then positions. The second round is finer and starts from the best pose of
    // the first.
    for (const double scale : {1.0, 0.4}) {
        if (scale < 1.0 || order == SearchOrder::headings_first) {
            consider_headings(Pose2(best), scale);
            for_each_place(Pose2(best), scale, consider);
        }
    }
    return best;
}

ScanMatch ScanMatcher::match(const OccupancyGrid& grid, const MatchPoints& points, const Pose2& initial,
                             const PosePrior& prior) {
    const ScanMatch direct = match_directly(grid, points, initial, prior);
    if (!is_doubtful(direct)) {
        return direct;
    }
    const std::array start{search(grid, points, initial)};
    return match_from(start, direct, grid, points, initial, prior);
}

ScanMatch ScanMatcher::match_directly(const OccupancyGrid& grid, const MatchPoints& points, const Pose2& initial,
                                      const PosePrior& prior) {
    surfaces_.begin(points);
    return refine(grid, points, initial, initial, information_of(prior, initial.theta_rad));
}

ScanMatch ScanMatcher::match_from(std::span<const Pose2> starts, const ScanMatch& direct, const OccupancyGrid& grid,
                                  const MatchPoints& points, const Pose2& initial, const PosePrior& prior) {
    surfaces_.begin(points);
    Pose2 start = starts.front();
    if (starts.size() > 1) {
        double best_score = -1.0;
        for (const Pose2& pose : starts) {
            const double pose_score = scored(grid, points, pose, search_stride);
            if (pose_score > best_score) {
                best_score = pose_score;
                start = pose;
            }
        }
    }
    const ScanMatch searched = refine(grid, points, start, initial, information_of(prior, initial.theta_rad));
    return searched.score > direct.score ? searched : direct;
}

double ScanMatcher::score(const OccupancyGrid& grid, const MatchPoints& points, const Pose2& pose, std::size_t stride) {
    surfaces_.begin(points);
    return scored(grid, points, pose, stride);
}

double ScanMatcher::scored(const OccupancyGrid& grid, const MatchPoints& points, const Pose2& pose,
                           std::size_t stride) {
    surfaces_.find(grid, points, pose, MeasuredAcross::scan_surfaces, stride);
    const double sum =
        sum_of_scores(arrays_of(points, surfaces_.residuals()), points.x.size(), stride, inverse_reach2_);
    return sum / static_cast<double>(std::max<std::size_t>(points.beams, 1));
}

}  // namespace ddtool

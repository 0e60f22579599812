#include "ddtool/filter/scan_matcher.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "base/lanes.hpp"
#include "base/squared.hpp"
#include "filter/beam_sums.hpp"
#include "filter/pose_covariance.hpp"

namespace ddtool {
namespace {

/// Gauss-Newton has converged when a step is smaller than this, which is a fiftieth of a cell of the default size.
constexpr double settled_m = 1e-3;
constexpr double settled_rad = 5e-4;

struct Rotation {
    float c, s;
    explicit Rotation(double theta_rad)
        : c(static_cast<float>(std::cos(theta_rad))), s(static_cast<float>(std::sin(theta_rad))) {}
};

/// The number of a cell. Cells beyond most_cells have no numbers. No map reaches that far, so the outermost number
/// serves for them.
int number_of(double whole_cells) { return static_cast<int>(std::clamp(whole_cells, -most_cells, most_cells)); }

/// A pose in cells. The whole part is kept separately, so that floats stay precise far from the origin.
struct CellPose {
    int x0, y0;
    float x, y;
    CellPose(const Pose2& pose, double cell_size_m) : CellPose(pose.x_m / cell_size_m, pose.y_m / cell_size_m) {}

private:
    CellPose(double x_cells, double y_cells)
        : x0(number_of(std::floor(x_cells))),
          y0(number_of(std::floor(y_cells))),
          x(static_cast<float>(x_cells - std::floor(x_cells))),
          y(static_cast<float>(y_cells - std::floor(y_cells))) {}
};

/// Rounds down without std::floor, which is a library call on processors without SSE4.1. Works for values above -16384;
/// here they are cells from the robot, and the settings allow no longer range.
int floor_of(float value) {
    constexpr int offset = 1 << 14;
    return static_cast<int>(value + static_cast<float>(offset)) - offset;
}

/// Turns one block of vectors by the angle with the cosine c and the sine s, and moves them by (tx, ty).
DDTOOL_VECTORISED void move_block(const float* x, const float* y, float c, float s, float tx, float ty, float* out_x,
                                  float* out_y) {
    Lanes px;
    Lanes py;
    load(px, x);
    load(py, y);
    store(out_x, c * px - s * py + tx);
    store(out_y, s * px + c * py + ty);
}

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

std::vector<float> padded(const std::vector<float>& values, double scale) {
    std::vector<float> result(round_up_to_lanes(values.size()), 0.0F);
    std::transform(values.begin(), values.end(), result.begin(),
                   [&](float value) { return static_cast<float>(static_cast<double>(value) * scale); });
    return result;
}

}  // namespace

Eigen::Matrix3d information_of(const PosePrior& prior, double theta_rad) {
    const Eigen::Matrix3d world_from_robot = turned_about_z(theta_rad);
    const Eigen::Vector3d sigma(prior.sigma_along_m, prior.sigma_across_m, prior.sigma_turn_rad);
    return world_from_robot * sigma.cwiseAbs2().cwiseInverse().asDiagonal() * world_from_robot.transpose();
}

void Residuals::resize(std::size_t beams) {
    for (std::vector<float>* values : {&x, &y, &normal_x, &normal_y, &along_weight, &found, &known}) {
        values->resize(beams);
    }
    occupied.resize(beams);
}

MatchPoints::MatchPoints(const ScanPoints& points, double cell_size_m)
    : x(padded(points.x_m, 1.0 / cell_size_m)),
      y(padded(points.y_m, 1.0 / cell_size_m)),
      normal_x(padded(points.normal_x, 1.0)),
      normal_y(padded(points.normal_y, 1.0)),
      along_weight(padded(points.along_weight, 1.0)),
      counts(padded(std::vector<float>(points.size(), 1.0F), 1.0)),
      beams(points.size()) {}

ScanMatcher::ScanMatcher(const ScanMatcherSettings& settings, double cell_size_m)
    : settings_(settings),
      cell_size_m_(cell_size_m),
      inverse_reach2_(static_cast<float>(squared(cell_size_m / settings.reach_m))),
      lines_(cell_size_m) {}

void ScanMatcher::find_nearest(const OccupancyGrid& grid, const MatchPoints& points, const Pose2& pose,
                               std::size_t stride) {
    const Rotation rotation(pose.theta_rad);
    const CellPose origin(pose, cell_size_m_);
    residuals_.resize(points.x.size());
    for (std::size_t block = 0; block < points.x.size(); block += stride * lane_count) {
        float* ex = residuals_.x.data() + block;
        float* ey = residuals_.y.data() + block;
        // The end points, in cells relative to the corner of the cell (x0, y0), become residuals below.
        move_block(points.x.data() + block, points.y.data() + block, rotation.c, rotation.s, origin.x, origin.y, ex,
                   ey);
        move_block(points.normal_x.data() + block, points.normal_y.data() + block, rotation.c, rotation.s, 0.0F, 0.0F,
                   residuals_.normal_x.data() + block, residuals_.normal_y.data() + block);
        std::copy_n(points.along_weight.data() + block, lane_count, residuals_.along_weight.data() + block);
        for (std::size_t lane = 0; lane < lane_count; ++lane) {
            const int cell_x = floor_of(ex[lane]);
            const int cell_y = floor_of(ey[lane]);
            const Cell cell{origin.x0 + cell_x, origin.y0 + cell_y};
            const NearestPoint nearest = grid.nearest(cell);
            constexpr float unit = 1.0F / NearestPoint::units_per_cell;
            ex[lane] -= static_cast<float>(cell_x) + 0.5F + unit * (static_cast<float>(nearest.x) + 0.5F);
            ey[lane] -= static_cast<float>(cell_y) + 0.5F + unit * (static_cast<float>(nearest.y) + 0.5F);
            const bool known = !nearest.none() || grid.log_odds(cell) != Patch::unknown;
            residuals_.occupied[block + lane] = cell_of(nearest, cell);
            residuals_.found[block + lane] = nearest.none() ? 0.0F : points.counts[block + lane];
            residuals_.known[block + lane] = known ? points.counts[block + lane] : 0.0F;
        }
    }
}

void ScanMatcher::find_residuals(const OccupancyGrid& grid, const MatchPoints& points, const Pose2& pose) {
    find_nearest(grid, points, pose, 1);
    for (std::size_t beam = 0; beam < points.beams; ++beam) {
        if (residuals_.found[beam] == 0.0F) {
            continue;
        }
        const MapLine line = lines_.through(grid, residuals_.occupied[beam]);
        if (line.exists()) {
            residuals_.x[beam] -= line.x;
            residuals_.y[beam] -= line.y;
            residuals_.normal_x[beam] = line.normal_x;
            residuals_.normal_y[beam] = line.normal_y;
            residuals_.along_weight[beam] = 0.0F;
        }
    }
}

ScanMatcher::Normal ScanMatcher::normal_equations(const MatchPoints& points, const Pose2& pose) const {
    const Rotation rotation(pose.theta_rad);
    Sums sums{};
    add_normal_equations(arrays_of(points, residuals_), points.x.size(), rotation.c, rotation.s, inverse_reach2_, sums);
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
    normal.gradient = per_m2 * m * Eigen::Vector3d(sums[gx], sums[gy], m * sums[gt]);
    return normal;
}

double ScanMatcher::log_likelihood(const MatchPoints& points) const {
    const double inverse = 0.5 * squared(cell_size_m_ / settings_.beam_sigma_m);
    const double miss = 0.5 * squared(settings_.reach_m / settings_.beam_sigma_m);
    LogLikelihood result;
    add_log_likelihoods(arrays_of(points, residuals_), points.x.size(), static_cast<float>(inverse),
                        static_cast<float>(miss), result);
    // If all beams end in ground that was never observed, the scan says nothing about the pose, and each beam counts as
    // a miss.
    const double mean = result.known_beams > 0.0 ? result.sum / result.known_beams : -miss;
    return mean * static_cast<double>(points.beams);
}

ScanMatch ScanMatcher::evaluate(const OccupancyGrid& grid, const MatchPoints& points, const Pose2& pose) {
    find_residuals(grid, points, pose);
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
        if (with_lines) {
            find_residuals(grid, points, pose);
        } else {
            find_nearest(grid, points, pose, 1);
        }
        Normal normal = normal_equations(points, pose);
        const Eigen::Vector3d from_prediction(pose.x_m - predicted.x_m, pose.y_m - predicted.y_m,
                                              wrap_angle(pose.theta_rad - predicted.theta_rad));
        const Eigen::Matrix3d system = normal.match.information + prior_information;
        const Eigen::Vector3d step = -system.ldlt().solve(normal.gradient + prior_information * from_prediction);
        pose = {pose.x_m + step.x(), pose.y_m + step.y(), wrap_angle(pose.theta_rad + step.z())};
        if (with_lines && step.head<2>().norm() < settled_m && std::abs(step.z()) < settled_rad) {
            normal.match.log_likelihood = log_likelihood(points);
            normal.match.pose = pose;
            return normal.match;
        }
        with_lines = true;
    }
    return evaluate(grid, points, pose);
}

Pose2 ScanMatcher::search(const OccupancyGrid& grid, const MatchPoints& points, const Pose2& start) {
    Pose2 best = start;
    double best_score = score(grid, points, start, search_stride);
    const auto consider = [&](const Pose2& pose) {
        const double pose_score = score(grid, points, pose, search_stride);
        if (pose_score > best_score) {
            best_score = pose_score;
            best = pose;
        }
    };
    // Each round tries headings first and then positions. The second round is finer and starts from the best pose of
    // the first.
    constexpr int turn_steps = 10;
    constexpr int distance_steps = 3;
    for (int round = 0; round < 2; ++round) {
        const double scale = round == 0 ? 1.0 : 0.4;
        const Pose2 turn_centre = best;
        for (int turn = -turn_steps; turn <= turn_steps; ++turn) {
            const double angle = scale * settings_.search_turn_rad * turn / turn_steps;
            consider({turn_centre.x_m, turn_centre.y_m, wrap_angle(turn_centre.theta_rad + angle)});
        }
        const Pose2 centre = best;
        const double step_m = scale * settings_.search_distance_m / distance_steps;
        for (int x = -distance_steps; x <= distance_steps; ++x) {
            for (int y = -distance_steps; y <= distance_steps; ++y) {
                consider({centre.x_m + x * step_m, centre.y_m + y * step_m, centre.theta_rad});
            }
        }
    }
    return best;
}

ScanMatch ScanMatcher::match(const OccupancyGrid& grid, const MatchPoints& points, const Pose2& initial,
                             const PosePrior& prior) {
    const Eigen::Matrix3d prior_information = information_of(prior, initial.theta_rad);
    ScanMatch direct = refine(grid, points, initial, initial, prior_information);
    if (direct.score >= settings_.doubtful_score) {
        return direct;
    }
    const ScanMatch searched = refine(grid, points, search(grid, points, initial), initial, prior_information);
    return searched.score > direct.score ? searched : direct;
}

double ScanMatcher::score(const OccupancyGrid& grid, const MatchPoints& points, const Pose2& pose, std::size_t stride) {
    find_nearest(grid, points, pose, stride);
    const double sum = sum_of_scores(arrays_of(points, residuals_), points.x.size(), stride, inverse_reach2_);
    return sum / static_cast<double>(std::max<std::size_t>(points.beams, 1));
}

}  // namespace ddtool

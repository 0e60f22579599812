#include "logs/stream/scan_turn.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

namespace ddtool {
namespace {

constexpr double most_turn_rad = 0.7;
constexpr std::size_t most_beams = 400;  ///< of which a scan is thinned, because more do not make the turn much surer
constexpr std::size_t least_beams = 40;
constexpr float shift_cap_m = 0.3F;     ///< what a beam that does not fit costs
constexpr double same_surface_m = 0.3;  ///< neighbours that differ by more are not on one surface
constexpr double fits_m = 0.1;          ///< residuals beyond it lose weight
constexpr int refinements = 6;
/// Smaller steps do not matter to what the turns are used for.
constexpr double settled_rad = 1e-5;
constexpr double settled_m = 1e-4;
/// By how much the bearing of a point may change because the lidar moves sideways. Points nearer than twice the motion
/// are left out, so that the series below are exact to a millionth.
constexpr double most_parallax_rad = 0.5;
constexpr double least_fitting = 0.5;  ///< share of the compared beams that must fit

/// The ranges of every few beams of a scan; NaN where there is none.
class Profile {
public:
    Profile(const LaserScan& scan, std::size_t every)
        : step_rad_(scan.angle_increment_rad * static_cast<double>(every)) {
        const double most_m = scan.range_max_m > 0.0 ? scan.range_max_m : INFINITY;
        for (std::size_t beam = 0; beam < scan.ranges_m.size(); beam += every) {
            const float range_m = scan.ranges_m[beam];
            const bool is_range = std::isfinite(range_m) && range_m > 0.0F && static_cast<double>(range_m) < most_m;
            ranges_m_.push_back(is_range ? range_m : LaserScan::invalid);
        }
        const double circle = 2.0 * std::numbers::pi / std::abs(step_rad_);
        is_closed_ = std::abs(circle - static_cast<double>(ranges_m_.size())) < 1.5;
    }
    [[nodiscard]] std::size_t size() const { return ranges_m_.size(); }
    [[nodiscard]] double step_rad() const { return step_rad_; }
    [[nodiscard]] float at(std::ptrdiff_t beam) const {
        const auto count = static_cast<std::ptrdiff_t>(size());
        if (is_closed_) {
            beam = (beam % count + count) % count;
        }
        return beam < 0 || beam >= count ? LaserScan::invalid : ranges_m_[static_cast<std::size_t>(beam)];
    }

private:
    std::vector<float> ranges_m_;
    double step_rad_;
    bool is_closed_ = false;
};

struct Direction {
    double cosine;
    double sine;

    [[nodiscard]] Direction turned(const Direction& by) const {
        return {cosine * by.cosine - sine * by.sine, sine * by.cosine + cosine * by.sine};
    }
};

Direction direction_of(double angle_rad) { return {std::cos(angle_rad), std::sin(angle_rad)}; }

/// The same for angles up to most_parallax_rad, by the first terms of the series.
Direction direction_of_small(double angle_rad) {
    const double square = angle_rad * angle_rad;
    return {1.0 - square * (1.0 / 2.0 - square * (1.0 / 24.0 - square / 720.0)),
            angle_rad * (1.0 - square * (1.0 / 6.0 - square / 120.0))};
}

std::vector<Direction> directions_of(double first_rad, double step_rad, std::size_t beams) {
    std::vector<Direction> directions;
    for (std::size_t beam = 0; beam < beams; ++beam) {
        directions.push_back(direction_of(first_rad + static_cast<double>(beam) * step_rad));
    }
    return directions;
}

/// The whole number of beams by which the scans are turned against each other.
std::ptrdiff_t best_shift(const Profile& before, const Profile& after) {
    const auto most = static_cast<std::ptrdiff_t>(most_turn_rad / std::abs(before.step_rad()));
    const auto beams = static_cast<std::ptrdiff_t>(after.size());
    std::vector<float> before_m;  // from the beam -most on, so that the loop below needs no wrapping
    for (std::ptrdiff_t beam = -most; beam < beams + most; ++beam) {
        before_m.push_back(before.at(beam));
    }
    std::vector<float> after_m;
    for (std::ptrdiff_t beam = 0; beam < beams; ++beam) {
        after_m.push_back(after.at(beam));
    }
    std::ptrdiff_t best = 0;
    float least_cost = INFINITY;
    for (std::ptrdiff_t i = 0; i <= 2 * most; ++i) {
        const std::ptrdiff_t shift = (i % 2 == 0 ? 1 : -1) * ((i + 1) / 2);  // the smallest turn first
        const float* shifted_m = before_m.data() + most + shift;
        float cost = 0.0F;
        float compared = 0.0F;
        for (std::size_t beam = 0; beam < after_m.size(); ++beam) {
            const float difference_m = std::abs(after_m[beam] - shifted_m[beam]);
            cost += difference_m < shift_cap_m ? difference_m : (difference_m >= shift_cap_m ? shift_cap_m : 0.0F);
            compared += difference_m >= 0.0F ? 1.0F : 0.0F;
        }
        if (compared >= static_cast<float>(least_beams / 2) && cost / compared < least_cost) {
            least_cost = cost / compared;
            best = shift;
        }
    }
    return best;
}

}  // namespace

std::optional<double> turn_between(const LaserScan& before, const LaserScan& after) {
    const std::size_t beams = before.ranges_m.size();
    if (beams != after.ranges_m.size() || beams < least_beams ||
        before.angle_increment_rad != after.angle_increment_rad || before.angle_min_rad != after.angle_min_rad ||
        !(std::abs(before.angle_increment_rad) > 1e-6)) {
        return std::nullopt;
    }
    const std::size_t every = (beams + most_beams - 1) / most_beams;
    const Profile from(before, every);
    const Profile to(after, every);
    const double step_rad = from.step_rad();
    const std::vector<Direction> directions = directions_of(before.angle_min_rad, step_rad, to.size());
    Eigen::Vector3d motion(static_cast<double>(best_shift(from, to)) * step_rad, 0.0, 0.0);  // turn, x, y
    double fitting = 0.0;
    std::size_t compared = 0;
    for (int round = 0; round < refinements; ++round) {
        Eigen::Matrix3d information = Eigen::Matrix3d::Identity() * 1e-9;
        Eigen::Vector3d gradient = Eigen::Vector3d::Zero();
        fitting = 0.0;
        compared = 0;
        const Direction turn = direction_of(motion(0));
        for (std::size_t beam = 0; beam < to.size(); ++beam) {
            const auto range_m = static_cast<double>(to.at(static_cast<std::ptrdiff_t>(beam)));
            if (!std::isfinite(range_m)) {
                continue;
            }
            const Direction seen = directions[beam].turned(turn);
            const double parallax_rad = -(motion(1) * seen.sine - motion(2) * seen.cosine) / range_m;
            if (!(std::abs(parallax_rad) < most_parallax_rad)) {
                continue;
            }
            const double place = static_cast<double>(beam) + (motion(0) + parallax_rad) / step_rad;
            const auto left = static_cast<std::ptrdiff_t>(std::floor(place));
            const auto left_m = static_cast<double>(from.at(left));
            const auto right_m = static_cast<double>(from.at(left + 1));
            if (!(std::abs(right_m - left_m) < same_surface_m)) {
                continue;
            }
            const auto [cosine, sine] = seen.turned(direction_of_small(parallax_rad));
            const double slope = (right_m - left_m) / step_rad;
            const double before_m = left_m + (place - static_cast<double>(left)) * (right_m - left_m);
            const double residual_m = range_m - (before_m - motion(1) * cosine - motion(2) * sine);
            const Eigen::Vector3d jacobian(-slope, slope * sine / range_m + cosine, -slope * cosine / range_m + sine);
            const double weight = 1.0 / (1.0 + (residual_m / fits_m) * (residual_m / fits_m));
            information += weight * jacobian * jacobian.transpose();
            gradient += weight * residual_m * jacobian;
            fitting += std::abs(residual_m) < fits_m ? 1.0 : 0.0;
            ++compared;
        }
        const Eigen::Vector3d step = information.ldlt().solve(gradient);
        motion -= step;
        if (std::abs(step(0)) < settled_rad && step.tail<2>().norm() < settled_m) {
            break;
        }
    }
    const bool is_good = compared >= least_beams / 2 && fitting >= least_fitting * static_cast<double>(compared) &&
                         std::abs(motion(0)) < most_turn_rad;
    return is_good ? std::optional(motion(0)) : std::nullopt;
}

}  // namespace ddtool

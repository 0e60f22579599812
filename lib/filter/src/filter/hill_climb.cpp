#include "ddtool/filter/hill_climb.hpp"

#include <array>
#include <cmath>
#include <utility>

namespace ddtool {
namespace {

/// exp(-t) for t >= 0, to a relative error of 1e-13: a table, and the series from its entry on. std::exp() would take a
/// quarter of the time of the whole match.
class FallingExponential {
public:
    FallingExponential() {
        for (std::size_t i = 0; i < table_.size(); ++i) {
            table_[i] = std::exp(-static_cast<double>(i) * step);
        }
    }
    [[nodiscard]] double operator()(double t) const {
        constexpr double end = step * (entries - 1);
        if (!(t < end)) {
            return std::exp(-t);
        }
        const auto entry = static_cast<std::size_t>(t / step);
        const double r = static_cast<double>(entry) * step - t;
        return table_[entry] * (1.0 + r * (1.0 + r * (1.0 / 2 + r * (1.0 / 6))));
    }

private:
    static constexpr std::size_t entries = 1025;
    static constexpr double step = 1.0 / 1024;
    std::array<double, entries> table_{};
};

const FallingExponential falling_exponential;

}  // namespace

BeamFit HillClimb::fit(const HitMap& map, std::span<const Point2> ends, const Pose2& world_from_laser) {
    turn(ends, world_from_laser.theta_rad, straight_);
    return fit_of(map, straight_, world_from_laser.x_m, world_from_laser.y_m);
}

HillClimb::Found HillClimb::climb(const HitMap& map, std::span<const Point2> ends, const Pose2& start) {
    Found here{start, fit(map, ends, start)};
    double step_m = settings_.step_m;
    double turn_rad = settings_.turn_rad;
    for (int halvings = 0;;) {
        Found best = here;
        const auto consider = [&](const Turned& turned, const Pose2& pose) {
            const BeamFit there = fit_of(map, turned, pose.x_m, pose.y_m);
            if (there.score > best.fit.score) {
                best = {pose, there};
            }
        };
        const auto [x_m, y_m, theta_rad] = here.pose;
        consider(straight_, {x_m + step_m, y_m, theta_rad});
        consider(straight_, {x_m - step_m, y_m, theta_rad});
        consider(straight_, {x_m, y_m - step_m, theta_rad});
        consider(straight_, {x_m, y_m + step_m, theta_rad});
        turn(ends, theta_rad + turn_rad, left_);
        consider(left_, {x_m, y_m, theta_rad + turn_rad});
        turn(ends, theta_rad - turn_rad, right_);
        consider(right_, {x_m, y_m, theta_rad - turn_rad});
        if (best.fit.score > here.fit.score) {
            if (best.pose.theta_rad != theta_rad) {
                std::swap(straight_, best.pose.theta_rad > theta_rad ? left_ : right_);
            }
            here = best;
        } else if (halvings == settings_.halvings) {
            return here;
        } else {
            ++halvings;
            step_m *= 0.5;
            turn_rad *= 0.5;
        }
    }
}

void HillClimb::turn(std::span<const Point2> ends, double angle_rad, Turned& turned) {
    turned.clear();
    for_each_end(ends, {0.0, 0.0, angle_rad}, [&](const Point2& end) { turned.push_back(end); });
}

BeamFit HillClimb::fit_of(const HitMap& map, const Turned& turned, double x_m, double y_m) const {
    double score = 0.0;
    double distances_m2 = 0.0;
    std::size_t hits = 0;
    const double per_m2 = 1.0 / settings_.score_width_m2;
    for (const Point2& end : turned) {
        const double nearest = map.nearest_m2({x_m + end.x_m, y_m + end.y_m});
        if (nearest >= 0.0) {
            ++hits;
            distances_m2 += nearest;
            score += falling_exponential(per_m2 * nearest);
        }
    }
    const double missed = static_cast<double>(turned.size() - hits) * missed_m2;
    return {.score = score,
            .log_likelihood = -(distances_m2 + missed) / settings_.likelihood_width_m2,
            .beams = turned.size()};
}

}  // namespace ddtool

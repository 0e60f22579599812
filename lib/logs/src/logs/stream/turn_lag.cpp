#include "logs/stream/turn_lag.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "base/median.hpp"
#include "ddtool/robot/pose2.hpp"
#include "logs/stream/scan_turn.hpp"
#include "robot/stamps.hpp"

namespace ddtool {
namespace {

using Pairs = std::span<const ScanTurns::Pair>;

constexpr double least_turn_rad = 0.01;  ///< a pair of scans that turns by less does not count as turning
constexpr double longest_step_s = 1.0;   ///< between scans
constexpr double longest_hole_s = 0.5;   ///< between headings
constexpr double most_lag_s = 0.5;
constexpr double coarse_s = 0.01;
constexpr double fine_s = 0.001;
constexpr double curve_s = 0.02;  ///< half width of the parabola through the sums of squares
constexpr std::size_t least_turning = 20;
constexpr double most_sigma_s = 0.015;
constexpr double most_share = 0.3;
constexpr double sigmas = 4.0;
constexpr double least_lag_s = 0.02;
/// Errors of neighbouring pairs are not independent, because they share a scan, and a slip of the wheels lasts.
constexpr double correlation = 2.0;
constexpr double outlier_sigmas = 3.0;

/// The fit of the scans' turns to the odometry's at one lag.
struct Fit {
    double lag_s = 0.0;
    double scale = 1.0;
    double squares = 0.0;  ///< mean over the pairs, each limited
};

/// The sums of squares of one log, or one half of it.
class LagFit {
public:
    LagFit(Pairs pairs, const HeadingTrack& odometry, double ahead_s) : odometry_(odometry) {
        for (const ScanTurns::Pair& pair : pairs) {
            const auto seconds = [&](std::int64_t ns) { return seconds_between(odometry.origin_ns(), ns) + ahead_s; };
            steps_.push_back({seconds(pair.from_ns), seconds(pair.to_ns), pair.turn_rad});
        }
    }

    std::optional<TurnLag> solve() {
        const Fit rough = best(-most_lag_s, most_lag_s, coarse_s);
        const double sigma_rad = deviation(rough);
        limit_rad_ = outlier_sigmas * std::max(sigma_rad, 1e-4);
        const Fit coarse = best(-most_lag_s, most_lag_s, coarse_s);
        const Fit fine = best(coarse.lag_s - coarse_s, coarse.lag_s + coarse_s, fine_s);
        if (!std::isfinite(fine.squares) || std::abs(fine.lag_s) > most_lag_s - curve_s) {
            return std::nullopt;
        }
        const Fit before = at(fine.lag_s - curve_s);
        const Fit after = at(fine.lag_s + curve_s);
        const double curvature = (before.squares + after.squares - 2.0 * fine.squares) / (2.0 * curve_s * curve_s);
        const double count = static_cast<double>(used_);
        if (!(curvature > 0.0) || count < static_cast<double>(least_turning)) {
            return std::nullopt;
        }
        const double slope = (after.squares - before.squares) / (2.0 * curve_s);
        const double shift_s = std::clamp(-slope / (2.0 * curvature), -fine_s, fine_s);
        return TurnLag{.late_s = fine.lag_s + shift_s,
                       .sigma_s = std::sqrt(correlation * fine.squares / (count * curvature)),
                       .scale = fine.scale,
                       .share = fine.squares * count / std::max(turns_squared_, 1e-12),
                       .turning = turning_};
    }

private:
    struct Step {
        double from_s;
        double to_s;
        double turn_rad;
    };

    Fit best(double from_s, double to_s, double every_s) {
        Fit best{.squares = INFINITY};
        for (double lag_s = from_s; lag_s < to_s + every_s / 2.0; lag_s += every_s) {
            if (const Fit fit = at(lag_s); fit.squares < best.squares) {
                best = fit;
            }
        }
        return best;
    }

    Fit at(double lag_s) {
        turns_.clear();
        turning_ = 0;
        turns_squared_ = 0.0;
        for (const Step& step : steps_) {
            if (const auto turn = odometry_.turn_rad(step.from_s + lag_s, step.to_s + lag_s)) {
                turns_.emplace_back(*turn, step.turn_rad);
                turning_ += std::abs(step.turn_rad) > least_turn_rad ? 1 : 0;
                turns_squared_ += step.turn_rad * step.turn_rad;
            }
        }
        used_ = turns_.size();
        Fit fit{.lag_s = lag_s};
        for (int round = 0; round < 3; ++round) {
            double product = 0.0;
            double square = 0.0;
            for (const auto& [odometry_rad, scan_rad] : turns_) {
                if (round == 0 || std::abs(scan_rad - fit.scale * odometry_rad) < limit_rad_) {
                    product += odometry_rad * scan_rad;
                    square += odometry_rad * odometry_rad;
                }
            }
            fit.scale = square > 0.0 ? product / square : 0.0;
        }
        for (const auto& [odometry_rad, scan_rad] : turns_) {
            const double residual_rad = std::min(std::abs(scan_rad - fit.scale * odometry_rad), limit_rad_);
            fit.squares += residual_rad * residual_rad;
        }
        fit.squares = turning_ < least_turning ? INFINITY : fit.squares / static_cast<double>(used_);
        return fit;
    }

    /// The robust standard deviation of the residuals.
    double deviation(const Fit& fit) {
        at(fit.lag_s);
        std::vector<double> residuals;
        for (const auto& [odometry_rad, scan_rad] : turns_) {
            residuals.push_back(std::abs(scan_rad - fit.scale * odometry_rad));
        }
        return 1.4826 * upper_median(std::move(residuals));
    }

    const HeadingTrack& odometry_;
    std::vector<Step> steps_;
    std::vector<std::pair<double, double>> turns_;  ///< of the odometry and the scans, at the lag looked at last
    std::size_t turning_ = 0;
    std::size_t used_ = 0;
    double turns_squared_ = 0.0;
    double limit_rad_ = 0.1;
};

}  // namespace

void ScanTurns::add(const LaserScan& scan) {
    if (is_full()) {
        return;
    }
    if (before_) {
        ++compared_;
        const double step_s = seconds_between(before_->stamp_ns, scan.stamp_ns);
        const std::optional<double> turn =
            step_s > 0.0 && step_s < longest_step_s ? turn_between(*before_, scan) : std::nullopt;
        const bool turns = turn && std::abs(*turn) > least_turn_rad;
        if (turn && (turns || turned_)) {
            pairs_.push_back({before_->stamp_ns, scan.stamp_ns, *turn});
        }
        turned_ = turns;
    }
    before_ = scan;
}

void HeadingTrack::add(std::int64_t stamp_ns, double heading_rad) {
    if (headings_.size() >= most_headings || !std::isfinite(heading_rad)) {
        return;
    }
    origin_ns_ = headings_.empty() ? stamp_ns : origin_ns_;
    const double at_s = seconds_between(origin_ns_, stamp_ns);
    if (headings_.empty()) {
        headings_.emplace_back(at_s, heading_rad);
    } else if (at_s > headings_.back().first) {
        headings_.emplace_back(at_s, headings_.back().second + wrap_angle(heading_rad - last_rad_));
    }
    last_rad_ = heading_rad;
}

std::optional<double> HeadingTrack::heading_at(double at_s) const {
    const auto after = std::ranges::lower_bound(headings_, at_s, {}, &std::pair<double, double>::first);
    if (after == headings_.begin() || after == headings_.end()) {
        return std::nullopt;
    }
    const auto& [from_s, from_rad] = *(after - 1);
    const auto& [to_s, to_rad] = *after;
    if (to_s - from_s > longest_hole_s) {
        return std::nullopt;
    }
    return from_rad + (at_s - from_s) / (to_s - from_s) * (to_rad - from_rad);
}

std::optional<double> HeadingTrack::turn_rad(double from_s, double to_s) const {
    const std::optional<double> from_rad = heading_at(from_s);
    const std::optional<double> to_rad = heading_at(to_s);
    return from_rad && to_rad ? std::optional(*to_rad - *from_rad) : std::nullopt;
}

bool TurnLag::is_significant() const { return std::abs(late_s) > std::max(least_lag_s, sigmas * sigma_s); }

std::optional<TurnLag> turn_lag(const ScanTurns& scans, const HeadingTrack& odometry, double ahead_s) {
    const Pairs pairs(scans.pairs());
    const std::optional<TurnLag> whole = LagFit(pairs, odometry, ahead_s).solve();
    if (!whole || whole->sigma_s > most_sigma_s || whole->share > most_share || std::abs(whole->scale) < 0.5 ||
        std::abs(whole->scale) > 2.0) {
        return std::nullopt;
    }
    for (const Pairs& half : {pairs.first(pairs.size() / 2), pairs.subspan(pairs.size() / 2)}) {
        const std::optional<TurnLag> part = LagFit(half, odometry, ahead_s).solve();
        const bool agrees =
            !part || std::abs(part->late_s - whole->late_s) < std::max(least_lag_s, sigmas * part->sigma_s);
        if (!agrees) {
            return std::nullopt;
        }
    }
    return whole;
}

}  // namespace ddtool

#include "logs/stream/gyro_trial.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "robot/scan_alignment.hpp"
#include "robot/stamps.hpp"

namespace ddtool {
namespace {

constexpr double pair_s = 1.0;
constexpr double pair_rad = 0.2;
constexpr double longest_pair_s = 2.0;
/// Of scans that lie on each other.
constexpr double least_matched_share = 0.7;
constexpr double largest_residual_m = 0.06;
constexpr double degree_rad = std::numbers::pi / 180.0;
constexpr double fitting_share = 0.2;
constexpr double most_medians = 3.0;
constexpr int rounds = 3;

}  // namespace

bool GyroTrial::add(const SensorFrame& frame, const GyroTrack& gyro) {
    if (is_complete()) {
        return false;
    }
    Scan scan{frame.scan.stamp_ns, frame.odom_from_robot, alignment_points(frame, frame.sweep)};
    const double since_s = before_ ? seconds_between(before_->stamp_ns, scan.stamp_ns) : -1.0;
    if (!(since_s > 0.0 && since_s < longest_pair_s)) {
        before_ = std::move(scan);
        return false;
    }
    const Pose2 motion = between(before_->odom_from_robot, scan.odom_from_robot);
    const std::optional<double> turn_rad = gyro.turn_rad(before_->stamp_ns, scan.stamp_ns);
    if (turn_rad && since_s < pair_s && std::abs(motion.theta_rad) < pair_rad && std::abs(*turn_rad) < pair_rad) {
        return false;
    }
    const std::size_t before = pairs_.size();
    if (turn_rad) {
        const ScanAlignment alignment = align_scans(before_->points_m, scan.points_m, motion);
        if (alignment.matched_share >= least_matched_share && alignment.residual_m <= largest_residual_m) {
            pairs_.push_back({alignment.first_from_second.theta_rad, motion.theta_rad, *turn_rad, since_s});
        }
    }
    before_ = std::move(scan);
    return pairs_.size() > before;
}

bool GyroTrial::is_decided() const {
    const std::optional<GyroVerdict> found = verdict();
    return found && found->is_better && found->pairs >= deciding_pairs;
}

std::vector<double> GyroTrial::gyro_turns_rad(double scale) const {
    std::vector<double> turns_rad;
    for (const Pair& pair : pairs_) {
        turns_rad.push_back(scale * pair.gyro_rad);
    }
    return turns_rad;
}

GyroTrial::Fit GyroTrial::fit(const std::vector<double>& turns_rad, bool has_bias) const {
    Fit fit;
    fit.errors_rad.assign(pairs_.size(), 0.0);
    double largest_rad = INFINITY;
    for (int round = 0; round < rounds; ++round) {
        double products = 0.0;
        double squares = 0.0;
        for (std::size_t i = 0; i < pairs_.size(); ++i) {
            if (fit.errors_rad[i] <= largest_rad) {
                products += (turns_rad[i] - pairs_[i].scans_rad) * pairs_[i].duration_s;
                squares += pairs_[i].duration_s * pairs_[i].duration_s;
            }
        }
        fit.bias_rad_per_s = has_bias ? products / squares : 0.0;
        for (std::size_t i = 0; i < pairs_.size(); ++i) {
            fit.errors_rad[i] =
                std::abs(turns_rad[i] - fit.bias_rad_per_s * pairs_[i].duration_s - pairs_[i].scans_rad);
        }
        std::vector<double> sorted_rad = fit.errors_rad;
        std::ranges::sort(sorted_rad);
        fit.median_rad = sorted_rad[sorted_rad.size() / 2];
        largest_rad = most_medians * fit.median_rad;
    }
    double weighted = 0.0;
    double squares = 0.0;
    for (std::size_t i = 0; i < pairs_.size(); ++i) {
        weighted += std::abs(pairs_[i].scans_rad) * fit.errors_rad[i];
        squares += pairs_[i].scans_rad * pairs_[i].scans_rad;
    }
    fit.share = weighted / squares;
    return fit;
}

std::optional<GyroVerdict> GyroTrial::verdict() const {
    double turn_rad = 0.0;
    std::vector<double> odometry_turns_rad;
    for (const Pair& pair : pairs_) {
        turn_rad += std::abs(pair.scans_rad);
        odometry_turns_rad.push_back(pair.odometry_rad);
    }
    if (pairs_.size() < least_pairs || turn_rad < least_turn_rad) {
        return std::nullopt;
    }
    GyroVerdict verdict;
    verdict.pairs = pairs_.size();
    Fit best;
    for (const double scale : {1.0, -1.0, degree_rad, -degree_rad}) {
        Fit found = fit(gyro_turns_rad(scale), true);
        if (best.errors_rad.empty() || found.share < best.share) {
            best = std::move(found);
            verdict.scale = scale;
        }
    }
    const auto count = static_cast<double>(pairs_.size());
    const Fit odometry = fit(odometry_turns_rad, false);
    verdict.bias_rad_per_s = best.bias_rad_per_s;
    verdict.error_rad = best.median_rad;
    verdict.odometry_error_rad = odometry.median_rad;
    verdict.fits = best.share < fitting_share;
    const double most_rad = most_medians * odometry.median_rad;
    double sum = 0.0;
    double squares = 0.0;
    double odometry_sum = 0.0;
    for (std::size_t i = 0; i < pairs_.size(); ++i) {
        const double odometry_rad = std::min(odometry.errors_rad[i], most_rad);
        const double gain = odometry_rad - std::min(best.errors_rad[i], most_rad);
        odometry_sum += odometry_rad;
        sum += gain;
        squares += gain * gain;
    }
    const double mean = sum / count;
    const double deviation = std::sqrt(std::max(squares / count - mean * mean, 0.0) / count);
    verdict.is_better = verdict.fits && sum > least_gain * odometry_sum && mean > least_deviations * deviation;
    return verdict;
}

}  // namespace ddtool

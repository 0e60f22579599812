#include "robot/sweep_trial.hpp"

#include <algorithm>
#include <cmath>

#include "robot/scan_alignment.hpp"
#include "robot/stamps.hpp"
#include "robot/sweep.hpp"

namespace ddtool {
namespace {

/// Of a lidar with many scans a second only some are taken, so that the memory of a second is small.
constexpr double apart_s = 0.08;
constexpr double partner_within_s = 1.5;
/// Partners see the same surfaces from about the same place.
constexpr double partner_within_m = 0.4;
constexpr double partner_within_rad = 1.2;
/// The distortions of the two scans must differ by this much three metres away, several times the noise of the ranges
/// after averaging.
constexpr double least_difference_m = 0.05;
constexpr double view_m = 3.0;
/// Pairs that do not lie on each other by any candidate, for example because people walk by, say nothing.
constexpr double largest_residual_m = 0.1;

/// How far two motions during a scan move a point three metres away from each other.
double difference_m(const Pose2& a, const Pose2& b) {
    return distance_m(a, b) + view_m * std::abs(wrap_angle(a.theta_rad - b.theta_rad));
}

}  // namespace

void SweepTrial::add(const SensorFrame& frame, const std::vector<std::vector<Pose2>>& sweeps) {
    if (costs_.size() >= most_pairs) {
        return;
    }
    Scan scan;
    scan.stamp_ns = frame.scan.stamp_ns;
    scan.odom_from_robot = frame.odom_from_robot;
    const auto since_s = [&](const Scan& other) { return seconds_between(other.stamp_ns, scan.stamp_ns); };
    while (!latest_.empty() && !(std::abs(since_s(latest_.front())) < partner_within_s)) {
        latest_.pop_front();
    }
    if (!latest_.empty() && std::abs(since_s(latest_.back())) < apart_s) {
        return;
    }
    for (const std::vector<Pose2>& sweep : sweeps) {
        if (!sweep.empty()) {
            const Pose2 motion = between(sweep.front(), sweep.back());
            const Pose2 forwards = sweep.front() == Pose2{} ? motion : inverse(motion);
            if (difference_m(forwards, {}) > difference_m(scan.longest_motion, {})) {
                scan.longest_motion = forwards;
            }
        }
        scan.points_m.push_back(alignment_points(frame, sweep));
    }
    if (const Scan* partner = partner_of(scan)) {
        compare(*partner, scan);
    }
    latest_.push_back(std::move(scan));
}

/// The latest scans' one whose motion differs most.
const SweepTrial::Scan* SweepTrial::partner_of(const Scan& scan) const {
    const Scan* best = nullptr;
    double largest_m = least_difference_m;
    for (const Scan& other : latest_) {
        const Pose2 apart = between(other.odom_from_robot, scan.odom_from_robot);
        const double apart_m = difference_m(other.longest_motion, scan.longest_motion);
        if (apart_m > largest_m && std::hypot(apart.x_m, apart.y_m) < partner_within_m &&
            std::abs(apart.theta_rad) < partner_within_rad) {
            largest_m = apart_m;
            best = &other;
        }
    }
    return best;
}

void SweepTrial::compare(const Scan& first, const Scan& second) {
    const Pose2 guess = between(first.odom_from_robot, second.odom_from_robot);
    std::vector<double> costs;
    for (std::size_t candidate = 0; candidate < candidates_; ++candidate) {
        costs.push_back(align_scans(first.points_m[candidate], second.points_m[candidate], guess).residual_m);
    }
    if (std::ranges::min(costs) > largest_residual_m) {
        return;
    }
    costs_.push_back(std::move(costs));
    for (std::size_t candidate = 0; candidate < candidates_; ++candidate) {
        if (candidate != chosen_ && is_better(candidate, chosen_)) {
            chosen_ = candidate;
        }
    }
}

bool SweepTrial::is_better(std::size_t candidate, std::size_t other) const {
    constexpr double least_m = 1e-3;  // better agreement is none: ranges are given in millimetres
    double sum = 0.0;
    double squares = 0.0;
    for (const std::vector<double>& costs : costs_) {
        const double gain = std::log((costs[other] + least_m) / (costs[candidate] + least_m));
        sum += gain;
        squares += gain * gain;
    }
    const auto count = static_cast<double>(costs_.size());
    if (costs_.size() < least_pairs) {
        return false;
    }
    const double mean = sum / count;
    const double variance = std::max(squares / count - mean * mean, 0.0) / (count - 1.0);
    return mean > least_gain && mean > least_deviations * std::sqrt(variance);
}

}  // namespace ddtool

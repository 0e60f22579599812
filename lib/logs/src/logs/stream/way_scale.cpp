#include "logs/stream/way_scale.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>

#include "base/median.hpp"
#include "base/text.hpp"
#include "logs/stream/scan_motion.hpp"
#include "logs/stream/stamp_survey.hpp"
#include "robot/stamps.hpp"

namespace ddtool {
namespace {

/// A step is so long that the noise of a match, some millimetres, does not matter, and so short that the view stays.
constexpr double way_step_m = 0.1;
/// A lidar away from the robot's origin also moves when the robot turns, so that wider turns are left out.
constexpr double most_way_turn_rad = 0.1;
constexpr double longest_way_step_s = 20.0;  ///< for 10 cm; slower robots are not judged

/// Of scans that are not compared, because the next step is not expected to end yet.
constexpr std::size_t most_passed_over = 8;

constexpr double least_every_s = 0.04;
constexpr double stands_m = 0.001;

constexpr std::size_t least_way_pairs = 10;
constexpr int way_rounds = 4;
constexpr double outlier_medians = 3.0;
constexpr double least_limit_m = 0.001;
/// Of the squares of the scans' steps, what the odometry must explain at the best scale.
constexpr double least_explained = 0.6;
constexpr double most_between_halves = 1.5;

/// Wheels whose radius was taken for their diameter are wrong by 2, and no worn or slipping ones by more; feet are 3.3
/// times as many as metres.
constexpr double most_scale = 2.5;
/// No robot that maps with a lidar drives at 50 km/h (check/verdict.cpp has the same bound).
constexpr double fastest_robot_m_per_s = 15.0;

struct WayPair {
    std::complex<double> scans_m;
    std::complex<double> odometry_m;
};

/// scans = factor * odometry, by least squares; the argument of the factor is the lidar's yaw on the robot.
struct WayFit {
    std::complex<double> factor;
    double explained = 0.0;
};

std::vector<double> residuals_of(std::span<const WayPair> pairs, std::complex<double> factor) {
    std::vector<double> residuals_m;
    for (const WayPair& pair : pairs) {
        residuals_m.push_back(std::abs(pair.scans_m - factor * pair.odometry_m));
    }
    return residuals_m;
}

std::optional<WayFit> fit_way(std::span<const WayPair> pairs) {
    WayFit found;
    double limit_m = INFINITY;
    for (int round = 0; round < way_rounds; ++round) {
        const std::vector<double> residuals_m = residuals_of(pairs, found.factor);
        std::complex<double> products;
        double odometry_squares = 0.0;
        double scan_squares = 0.0;
        for (std::size_t i = 0; i < pairs.size(); ++i) {
            if (residuals_m[i] <= limit_m) {
                products += pairs[i].scans_m * std::conj(pairs[i].odometry_m);
                odometry_squares += std::norm(pairs[i].odometry_m);
                scan_squares += std::norm(pairs[i].scans_m);
            }
        }
        if (!(odometry_squares > 0.0) || !(scan_squares > 0.0)) {
            return std::nullopt;
        }
        found.factor = products / odometry_squares;
        found.explained = std::norm(products) / (odometry_squares * scan_squares);
        limit_m = std::max(outlier_medians * upper_median(residuals_of(pairs, found.factor)), least_limit_m);
    }
    return found;
}

/// The scans' steps are about equally long, and so are the odometry's except where it jumps.
void leave_out_leaps(std::vector<WayPair>& pairs) {
    constexpr double most_medians = 4.0;
    std::vector<double> lengths_m;
    for (const WayPair& pair : pairs) {
        lengths_m.push_back(std::abs(pair.odometry_m));
    }
    const double most_m = most_medians * upper_median(std::move(lengths_m));
    std::erase_if(pairs, [&](const WayPair& pair) { return std::abs(pair.odometry_m) > most_m; });
}

/// "as if it were in millimetres", for scales within a fifth of that of a unit.
std::string unit_text(double scale) {
    struct Unit {
        double per_metre;
        const char* name;
    };
    constexpr std::array<Unit, 5> units{
        {{1000.0, "millimetres"}, {100.0, "centimetres"}, {39.37, "inches"}, {3.281, "feet"}, {0.001, "kilometres"}}};
    const auto* const unit =
        std::ranges::find_if(units, [&](const Unit& each) { return std::abs(std::log(scale / each.per_metre)) < 0.2; });
    return unit == units.end() ? "" : ", as if it were in " + std::string(unit->name);
}

}  // namespace

void ScanWay::add(const LaserScan& scan) {
    if (is_full()) {
        return;
    }
    ++since_from_;
    if (passed_over_ > 0) {
        --passed_over_;
        return;
    }
    if (!from_) {
        start(scan);
        return;
    }
    const double since_s = seconds_between(from_->stamp_ns, scan.stamp_ns);
    ++compared_;
    const std::optional<Pose2> motion =
        since_s > 0.0 && since_s < longest_way_step_s ? motion_between(*from_, scan) : std::nullopt;
    if (!motion || std::abs(motion->theta_rad) >= most_way_turn_rad) {
        // A place where the scans do not tell the motion is likely to go on, and so is a turn.
        ++in_vain_;
        passed_over_ = std::min(std::size_t{1} << std::min(in_vain_, std::size_t{8}), most_passed_over) - 1;
        from_.reset();
        return;
    }
    in_vain_ = 0;
    const std::complex<double> moved_m{motion->x_m, motion->y_m};
    const double share = std::abs(moved_m) / way_step_m;
    if (share < 1.0) {
        const double left = (1.0 / std::max(share, 0.1) - 1.0) * static_cast<double>(since_from_);
        passed_over_ = std::min({static_cast<std::size_t>(left / 2.0), since_from_, most_passed_over});
        return;
    }
    steps_.push_back({from_->stamp_ns, scan.stamp_ns, moved_m});
    start(scan);
}

void ScanWay::start(const LaserScan& scan) {
    from_ = scan;
    since_from_ = 0;
}

void WayTrack::add(const StampedPose& odom_from_robot) {
    const Pose2& pose = odom_from_robot.pose;
    const bool is_finite = std::isfinite(pose.x_m) && std::isfinite(pose.y_m) && std::isfinite(pose.theta_rad);
    const bool is_later =
        poses_.empty() || seconds_between(poses_.back().stamp_ns, odom_from_robot.stamp_ns) > least_every_s;
    if (is_finite && is_later && poses_.size() < most_poses) {
        poses_.push_back(odom_from_robot);
    }
}

std::optional<Pose2> WayTrack::pose_at(std::int64_t stamp_ns) const {
    const auto after = std::ranges::lower_bound(poses_, stamp_ns, {}, &StampedPose::stamp_ns);
    if (after == poses_.end() || (after == poses_.begin() && after->stamp_ns != stamp_ns)) {
        return std::nullopt;
    }
    if (after->stamp_ns == stamp_ns) {
        return after->pose;
    }
    const StampedPose& before = *(after - 1);
    return interpolate(before.pose, after->pose,
                       seconds_between(before.stamp_ns, stamp_ns) / seconds_between(before.stamp_ns, after->stamp_ns));
}

std::optional<Pose2> WayTrack::moved(std::int64_t from_ns, std::int64_t to_ns) const {
    const std::optional<Pose2> from = pose_at(from_ns);
    const std::optional<Pose2> to = pose_at(to_ns);
    return from && to ? std::optional(between(*from, *to)) : std::nullopt;
}

double WayTrack::usual_m_per_s() const {
    std::vector<double> speeds_m_per_s;
    for (std::size_t i = 1; i < poses_.size(); ++i) {
        const double way_m = distance_m(poses_[i - 1].pose, poses_[i].pose);
        if (way_m > stands_m) {
            speeds_m_per_s.push_back(way_m / seconds_between(poses_[i - 1].stamp_ns, poses_[i].stamp_ns));
        }
    }
    return upper_median(std::move(speeds_m_per_s));
}

std::optional<double> way_scale(const ScanWay& scans, const WayTrack& odometry, double ahead_s) {
    std::vector<WayPair> pairs;
    const std::int64_t ahead_ns = std::llround(1e9 * ahead_s);
    for (const ScanWay::Step& step : scans.steps()) {
        if (const auto moved = odometry.moved(stamp_sum(step.from_ns, ahead_ns), stamp_sum(step.to_ns, ahead_ns))) {
            pairs.push_back({step.moved_m, {moved->x_m, moved->y_m}});
        }
    }
    leave_out_leaps(pairs);
    if (pairs.size() < least_way_pairs) {
        return std::nullopt;
    }
    const std::span<const WayPair> all(pairs);
    const std::optional<WayFit> whole = fit_way(all);
    const std::optional<WayFit> first = fit_way(all.first(all.size() / 2));
    const std::optional<WayFit> second = fit_way(all.subspan(all.size() / 2));
    if (!whole || !first || !second || whole->explained < least_explained ||
        std::abs(std::log(std::abs(first->factor / second->factor))) > std::log(most_between_halves)) {
        return std::nullopt;
    }
    return 1.0 / std::abs(whole->factor);
}

std::string length_fault(const ScanWay& scans, const WayTrack& odometry, double ahead_s) {
    const std::optional<double> scale = way_scale(scans, odometry, ahead_s);
    if (scale) {
        if (std::max(*scale, 1.0 / *scale) < most_scale) {
            return "";
        }
        const int decimals = *scale > 10.0 ? 0 : (*scale > 0.1 ? 2 : 5);
        return "it moves " + fixed_text(*scale, decimals) + " times as far as the scans show" + unit_text(*scale) +
               "; expected metres";
    }
    const double speed_m_per_s = odometry.usual_m_per_s();
    return speed_m_per_s > fastest_robot_m_per_s
               ? "it drives at " + fixed_text(speed_m_per_s, 0) + " m/s; expected metres, and stamps in seconds"
               : "";
}

}  // namespace ddtool

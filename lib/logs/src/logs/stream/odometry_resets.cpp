#include "logs/stream/odometry_resets.hpp"

#include <algorithm>
#include <cmath>

#include "base/text.hpp"
#include "robot/stamps.hpp"

namespace ddtool {
namespace {

constexpr std::size_t least_steps = 20;  ///< before that, nobody knows how far this robot moves between two poses
/// A step counts as a jump only if it is longer or wider than this, and that many times as large and as fast as the
/// largest and the fastest step before. Both are asked, because after a gap in the log an ordinary motion is large but
/// not fast, and between stamps that jitter it is fast but not large.
constexpr double jump_m = 0.3;
constexpr double jump_rad = 0.25;
constexpr double times_as_large = 3.0;
constexpr double times_as_fast = 2.5;
/// How fast a jump is at least, where a step as fast as `known` has been seen and where it has not.
struct LeastRates {
    double known;
    double of_known;
    double of_unknown;
};
constexpr LeastRates metres_per_s{0.3, 1.5, 3.0};
constexpr LeastRates rad_per_s{0.3, 3.0, 6.0};

constexpr double shortest_s = 0.01;     ///< stamps that are closer together are jitter
constexpr double at_origin = 1e-3;      ///< metres and radians
constexpr double speed_window_s = 0.2;  ///< over which the speed before a jump is taken, so that jitter averages out

double elapsed_s(const StampedPose& from, const StampedPose& to) { return seconds_between(from.stamp_ns, to.stamp_ns); }

}  // namespace

Pose2 OdometryResets::follow(const StampedPose& odom_from_robot) {
    last_jump_ = before_ ? find_jump(odom_from_robot) : std::nullopt;
    if (last_jump_) {
        const Pose2 motion = last_jump_->is_bridged ? motion_as_before(last_jump_->duration_s) : Pose2{};
        continuous_from_logged_ = continuous(before_->pose) * motion * inverse(odom_from_robot.pose);
        latest_.clear();
    }
    before_ = odom_from_robot;
    latest_.push_back(odom_from_robot);
    while (std::abs(elapsed_s(latest_.front(), odom_from_robot)) > speed_window_s) {
        latest_.pop_front();
    }
    return continuous(odom_from_robot.pose);
}

/// The motion in that time at the speed of the last poses: along the same arc.
Pose2 OdometryResets::motion_as_before(double duration_s) const {
    const double known_s = elapsed_s(latest_.front(), latest_.back());
    if (known_s < shortest_s) {
        return {};
    }
    const double share = duration_s / known_s;
    const Pose2 known = between(latest_.front().pose, latest_.back().pose);
    // In the frame of the chord's middle the motion is straight, whatever its length.
    const Pose2 half_turn{0.0, 0.0, known.theta_rad / 2.0};
    const Pose2 chord = inverse(half_turn) * Pose2{known.x_m, known.y_m, 0.0};
    const Pose2 turned{0.0, 0.0, share * known.theta_rad / 2.0};
    return turned * Pose2{share * chord.x_m, share * chord.y_m, share * known.theta_rad / 2.0};
}

/// Without a jump the pose as it is, to the last bit.
Pose2 OdometryResets::continuous(const Pose2& logged) const {
    return continuous_from_logged_ ? *continuous_from_logged_ * logged : logged;
}

std::string OdometryResets::text(const Jump& jump) {
    return "jumps by " + fixed_text(jump.distance_m, 2) + " m and " + fixed_text(jump.turn_rad, 2) + " rad in " +
           fixed_text(jump.duration_s, 2) + " s" + (jump.to_origin ? ", to its origin" : "") +
           "; this is taken for a reset, not for a motion; the motion meanwhile is " +
           (jump.is_bridged ? "taken to have gone on as before" : "worked out from the scans");
}

/// Notes the step from the last pose unless it is a jump.
std::optional<OdometryResets::Jump> OdometryResets::find_jump(const StampedPose& next) {
    const Pose2 moved = between(before_->pose, next.pose);
    const double since_s = std::abs(elapsed_s(*before_, next));
    const double duration_s = std::max(since_s, shortest_s);
    const double distance_m = std::hypot(moved.x_m, moved.y_m);
    const double turn_rad = std::abs(moved.theta_rad);
    const Pose2& pose = next.pose;
    const bool to_origin =
        std::hypot(pose.x_m, pose.y_m) < at_origin && std::abs(wrap_angle(pose.theta_rad)) < at_origin;
    const auto is_jump = [&](double size, const Step& largest, double least_size, const LeastRates& least) {
        const double rate = size / duration_s;
        const double least_rate = largest.rate < least.known ? least.of_unknown : least.of_known;
        return size > std::max(least_size, times_as_large * largest.size) &&
               (to_origin || rate > std::max(least_rate, times_as_fast * largest.rate));
    };
    if (steps_ >= least_steps &&
        (is_jump(distance_m, longest_, jump_m, metres_per_s) || is_jump(turn_rad, widest_, jump_rad, rad_per_s))) {
        return Jump{distance_m, turn_rad, since_s, to_origin, since_s <= longest_bridge_s};
    }
    ++steps_;
    longest_ = {std::max(longest_.size, distance_m), std::max(longest_.rate, distance_m / duration_s)};
    widest_ = {std::max(widest_.size, turn_rad), std::max(widest_.rate, turn_rad / duration_s)};
    return std::nullopt;
}

}  // namespace ddtool

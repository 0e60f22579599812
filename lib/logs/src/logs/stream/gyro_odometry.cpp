#include "logs/stream/gyro_odometry.hpp"
#include "robot/stamps.hpp"

#include <algorithm>
#include <cmath>

namespace ddtool {
namespace {

/// Wheels that turned less than this stand still.
constexpr double wheels_stand_m = 1e-4;
constexpr double wheels_stand_rad = 1e-4;
/// A gyro that reads more than this besides its bias turns, though the wheels stand: the robot is carried.
constexpr double still_rad_per_s = 0.05;
/// What the scans said of the bias counts as much as so many seconds of standing still, and the last ones count most.
constexpr double assumed_still_s = 2.0;
constexpr double remembered_still_s = 60.0;

double seconds_from(const StampedPose& from, const StampedPose& to) {
    return seconds_between(from.stamp_ns, to.stamp_ns);
}

}  // namespace

void GyroOdometry::use(double scale, double bias_rad_per_s) {
    scale_ = scale;
    bias_rad_per_s_ = bias_rad_per_s;
    still_s_ = assumed_still_s;
}

std::optional<StampedPose> GyroOdometry::next(bool at_end) {
    if (waiting_.empty()) {
        return std::nullopt;
    }
    const bool is_reached = gyro_.reaches(waiting_.front().stamp_ns);
    if (!at_end && !is_reached && std::abs(seconds_from(waiting_.front(), waiting_.back())) < longest_wait_s) {
        return std::nullopt;
    }
    const StampedPose pose = waiting_.front();
    waiting_.pop_front();
    odom_from_robot_ =
        before_ && scale_ ? odom_from_robot_ * corrected(between(before_->pose, pose.pose), *before_, pose) : pose.pose;
    before_ = pose;
    return StampedPose{pose.stamp_ns, odom_from_robot_};
}

/// A motion of the wheels with the turn of the gyro. The way between two poses of the odometry is an arc, so that its
/// direction changes by half of what the turn changes.
Pose2 GyroOdometry::corrected(const Pose2& motion, const StampedPose& before, const StampedPose& pose) {
    const std::optional<double> read_rad = gyro_.turn_rad(before.stamp_ns, pose.stamp_ns);
    const double duration_s = seconds_from(before, pose);
    if (!read_rad || !(duration_s > 0.0)) {
        return motion;
    }
    const double turn_rad = *scale_ * *read_rad - bias_rad_per_s_ * duration_s;
    if (std::hypot(motion.x_m, motion.y_m) < wheels_stand_m && std::abs(motion.theta_rad) < wheels_stand_rad &&
        std::abs(turn_rad) < still_rad_per_s * duration_s) {
        still_s_ = std::min(still_s_ + duration_s, remembered_still_s);
        bias_rad_per_s_ += turn_rad / still_s_;
        return motion;
    }
    const Pose2 aside{0.0, 0.0, 0.5 * wrap_angle(turn_rad - motion.theta_rad)};
    const Point2 way = aside * Point2{motion.x_m, motion.y_m};
    return {way.x_m, way.y_m, wrap_angle(turn_rad)};
}

}  // namespace ddtool

#include "sim/drive.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "ddtool/base/error.hpp"

namespace ddtool::sim {
namespace {

/// A leg has been driven when no more than this is left of it.
constexpr double reached_m = 0.01;
/// A way point counts as missed if the robot is farther away from it at the end of its leg.
constexpr double missed_m = 0.5;
/// Turning in place ends when the heading error is smaller than this.
constexpr double turned_rad = 0.02;
/// The turn rate is this times the heading error, within the limits on turning.
constexpr double heading_gain_per_s = 4.0;

struct Leg {
    Point2 from;
    double heading_rad = 0.0;
    double length_m = 0.0;
    double exit_speed_m_per_s = 0.0;

    [[nodiscard]] double travelled_m(const Pose2& pose) const {
        return (pose.x_m - from.x_m) * std::cos(heading_rad) + (pose.y_m - from.y_m) * std::sin(heading_rad);
    }
    [[nodiscard]] Point2 at(double distance_m) const {
        return {from.x_m + distance_m * std::cos(heading_rad), from.y_m + distance_m * std::sin(heading_rad)};
    }
};

Leg leg_between(const Point2& from, const Point2& to) {
    const double dx = to.x_m - from.x_m;
    const double dy = to.y_m - from.y_m;
    return {.from = from, .heading_rad = std::atan2(dy, dx), .length_m = std::hypot(dx, dy)};
}

/// The speed at the end of a leg: the sharper the corner, the lower, and 0 where the robot turns in place.
double corner_speed(const Leg& leg, const Leg& next, const DriveSettings& settings) {
    const double corner_rad = std::abs(wrap_angle(next.heading_rad - leg.heading_rad));
    return settings.speed_m_per_s * std::max(0.0, 1.0 - corner_rad / settings.turn_in_place_above_rad);
}

std::vector<Leg> legs_of(const Route& route, const DriveSettings& settings) {
    std::vector<Leg> legs;
    Point2 from{route.start.x_m, route.start.y_m};
    for (const Point2& to : all_way_points(route)) {
        legs.push_back(leg_between(from, to));
        from = to;
    }
    for (std::size_t i = 0; i + 1 < legs.size(); ++i) {
        legs[i].exit_speed_m_per_s = corner_speed(legs[i], legs[i + 1], settings);
    }
    return legs;
}

double approach(double value, double target, double step) { return value + std::clamp(target - value, -step, step); }

class Driver {
public:
    Driver(const DriveSettings& settings, const Pose2& start, double step_s)
        : settings_(settings), pose_(start), step_s_(step_s) {}

    [[nodiscard]] const Pose2& pose() const { return pose_; }
    [[nodiscard]] bool moving() const { return speed_ != 0.0 || turn_rate_ != 0.0; }
    [[nodiscard]] bool has_driven(const Leg& leg) const {
        return leg.length_m - leg.travelled_m(pose_) <= std::max(reached_m, speed_ * step_s_);
    }

    [[nodiscard]] bool has_reached(const Leg& leg) const {
        const Point2 end = leg.at(leg.length_m);
        return std::hypot(end.x_m - pose_.x_m, end.y_m - pose_.y_m) < missed_m;
    }

    void follow(const Leg& leg) {
        const double travelled_m = leg.travelled_m(pose_);
        const Point2 carrot = leg.at(travelled_m + settings_.lookahead_m);
        const double error_rad =
            wrap_angle(std::atan2(carrot.y_m - pose_.y_m, carrot.x_m - pose_.x_m) - pose_.theta_rad);
        turning_ = std::abs(error_rad) > (turning_ ? turned_rad : settings_.turn_in_place_above_rad);
        const double remaining_m = std::max(0.0, leg.length_m - travelled_m);
        move(turning_ ? 0.0 : braking_speed(remaining_m, leg.exit_speed_m_per_s), steering_rate(error_rad));
    }

    void brake() { move(0.0, 0.0); }

private:
    [[nodiscard]] double braking_speed(double remaining_m, double exit_speed) const {
        const double speed = std::sqrt(exit_speed * exit_speed + 2.0 * settings_.acceleration_m_per_s2 * remaining_m);
        return std::min(settings_.speed_m_per_s, speed);
    }

    /// The highest turn rate from which the robot can still stop turning when the error becomes zero. The exact limit
    /// is sqrt(2 a e) for the turn acceleration a and the error e; 1.6 in place of 2 leaves a margin.
    [[nodiscard]] double steering_rate(double error_rad) const {
        const double size = std::abs(error_rad);
        const double rate = std::min({settings_.turn_rate_rad_per_s, heading_gain_per_s * size,
                                      std::sqrt(1.6 * settings_.turn_acceleration_rad_per_s2 * size)});
        return std::copysign(rate, error_rad);
    }

    void move(double speed, double turn_rate) {
        speed_ = approach(speed_, speed, settings_.acceleration_m_per_s2 * step_s_);
        turn_rate_ = approach(turn_rate_, turn_rate, settings_.turn_acceleration_rad_per_s2 * step_s_);
        const double distance_m = speed_ * step_s_;
        const double turn_rad = turn_rate_ * step_s_;
        pose_ = pose_ * Pose2{distance_m * std::cos(turn_rad / 2.0), distance_m * std::sin(turn_rad / 2.0), turn_rad};
    }

    DriveSettings settings_;
    Pose2 pose_;
    double step_s_;
    double speed_ = 0.0;
    double turn_rate_ = 0.0;
    bool turning_ = false;
};

/// The time in seconds after which a leg is given up; ample for any drive that makes progress.
double patience_s(const Leg& leg, const DriveSettings& settings) {
    return 300.0 + 10.0 * leg.length_m / settings.speed_m_per_s;
}

void check(const DriveSettings& settings) {
    for (const double limit : {settings.speed_m_per_s, settings.acceleration_m_per_s2, settings.turn_rate_rad_per_s,
                               settings.turn_acceleration_rad_per_s2, settings.lookahead_m}) {
        if (!(limit > 0.0)) {
            throw UsageError("drive: expected speeds, accelerations and the lookahead above 0");
        }
    }
}

}  // namespace

Trajectory drive(const Route& route, const DriveSettings& settings, std::int64_t start_ns, std::int64_t step_ns) {
    check(settings);
    const double step_s = 1e-9 * static_cast<double>(step_ns);
    Driver driver(settings, route.start, step_s);
    Trajectory trajectory{{start_ns, route.start}};
    const auto record = [&] { trajectory.push_back({trajectory.back().stamp_ns + step_ns, driver.pose()}); };
    std::size_t number = 0;
    for (const Leg& leg : legs_of(route, settings)) {
        ++number;
        double spent_s = 0.0;
        for (; !driver.has_driven(leg) && spent_s < patience_s(leg, settings); spent_s += step_s) {
            driver.follow(leg);
            record();
        }
        if (!driver.has_reached(leg)) {
            throw UsageError("the robot does not reach way point " + std::to_string(number) +
                             "; expected one that can be driven to with these drive settings");
        }
    }
    while (driver.moving()) {
        driver.brake();
        record();
    }
    return trajectory;
}

}  // namespace ddtool::sim

#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <optional>

#include "ddtool/robot/sensor_stream.hpp"

namespace ddtool::test {

/// A robot that looks to and fro in a room of 9 x 6 m, at up to 1.5 rad/s, and drives a little. Its lidar turns five
/// times a second, with 240 beams, and is 0.2 m in front of the robot's centre.
struct SweptScans {
    /// How the beams are measured: 1 one after the other, -1 from the last to the first, 0 all at once.
    int order = 1;

    static constexpr double turn_s = 0.2;
    static constexpr double scan_every_s = 0.2;
    static constexpr std::size_t beams = 240;

    /// world_from_robot, which is also the odometry.
    static Pose2 robot_at(double t_s) {
        return {0.5 * std::sin(0.7 * t_s), 0.3 * std::cos(0.5 * t_s), std::sin(1.5 * t_s)};
    }

    /// The scan at a time, as its message would be, apart from times.
    [[nodiscard]] SensorFrame scan_at(double t_s) const {
        SensorFrame frame;
        frame.robot_from_laser = {0.2, 0.0, 0.0};
        frame.scan.stamp_ns = std::llround(t_s * 1e9);
        frame.scan.angle_min_rad = -std::numbers::pi;
        frame.scan.angle_increment_rad = 2.0 * std::numbers::pi / static_cast<double>(beams);
        frame.scan.range_min_m = 0.05;
        frame.scan.range_max_m = 20.0;
        frame.odom_from_robot = robot_at(t_s);
        frame.world_from_robot = robot_at(t_s);
        for (std::size_t beam = 0; beam < beams; ++beam) {
            const std::size_t place = order < 0 ? beams - 1 - beam : beam;
            const double later_s = order == 0 ? 0.0 : turn_s * static_cast<double>(place) / static_cast<double>(beams);
            const Pose2 laser = robot_at(t_s + later_s) * frame.robot_from_laser;
            frame.scan.ranges_m.push_back(range_m(laser, frame.scan.angle_rad(beam)));
        }
        return frame;
    }

    /// The scan of a robot that stands there.
    [[nodiscard]] static SensorFrame scan_at(const Pose2& world_from_robot) {
        SensorFrame frame = SweptScans{.order = 0}.scan_at(0.0);
        const Pose2 laser = world_from_robot * frame.robot_from_laser;
        for (std::size_t beam = 0; beam < beams; ++beam) {
            frame.scan.ranges_m[beam] = range_m(laser, frame.scan.angle_rad(beam));
        }
        frame.odom_from_robot = world_from_robot;
        frame.world_from_robot = world_from_robot;
        return frame;
    }

private:
    static float range_m(const Pose2& laser, double angle_rad) {
        const double direction = laser.theta_rad + angle_rad;
        const double c = std::cos(direction);
        const double s = std::sin(direction);
        const double to_x = ((c > 0.0 ? 4.5 : -4.5) - laser.x_m) / c;
        const double to_y = ((s > 0.0 ? 3.0 : -3.0) - laser.y_m) / s;
        return static_cast<float>(std::min(to_x, to_y));
    }
};

}  // namespace ddtool::test

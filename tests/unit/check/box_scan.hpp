#pragma once

#include <cmath>
#include <numbers>

#include "ddtool/robot/sensor_stream.hpp"

namespace ddtool::check::test {

/// A rectangle of walls, about the origin.
struct Box {
    double half_length_m = 3.0;  ///< along x
    double half_width_m = 2.0;   ///< along y
};

/// What a lidar of 360 beams sees from a pose inside the box; echoes beyond range_max_m are missing.
inline SensorFrame seen_from(const Pose2& pose, const Box& box = {}, double range_max_m = 30.0) {
    SensorFrame frame;
    frame.scan.angle_min_rad = -std::numbers::pi;
    frame.scan.angle_increment_rad = 2.0 * std::numbers::pi / 360.0;
    frame.scan.range_max_m = range_max_m;
    for (std::size_t beam = 0; beam < 360; ++beam) {
        const double angle = pose.theta_rad + frame.scan.angle_rad(beam);
        const double c = std::cos(angle);
        const double s = std::sin(angle);
        const double to_end = c == 0.0 ? 1e9 : (std::copysign(box.half_length_m, c) - pose.x_m) / c;
        const double to_side = s == 0.0 ? 1e9 : (std::copysign(box.half_width_m, s) - pose.y_m) / s;
        const double range_m = std::min(to_end, to_side);
        frame.scan.ranges_m.push_back(range_m > range_max_m ? LaserScan::no_return : static_cast<float>(range_m));
    }
    frame.odom_from_robot = pose;
    return frame;
}

}  // namespace ddtool::check::test

#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "ddtool/base/random.hpp"
#include "ddtool/robot/laser_scan.hpp"
#include "ddtool/robot/pose2.hpp"

namespace ddtool::test {

/// A rectangle whose middle is the origin.
struct Room {
    double half_length_m = 4.5;  ///< along x
    double half_width_m = 3.0;
};

/// A scan of a full turn in an empty room, with noise of 1 cm; what is farther than 30 m away has no return.
inline LaserScan room_scan(const Pose2& pose, double stamp_s, RandomStream& random, int beams = 360,
                           const Room& room = {}) {
    LaserScan scan;
    scan.stamp_ns = std::llround(1e9 * stamp_s);
    scan.angle_min_rad = -std::numbers::pi;
    scan.angle_increment_rad = 2.0 * std::numbers::pi / beams;
    scan.range_max_m = 30.0;
    for (int beam = 0; beam < beams; ++beam) {
        const double angle = pose.theta_rad + scan.angle_rad(static_cast<std::size_t>(beam));
        const double length_m = std::cos(angle) > 0.0 ? room.half_length_m : -room.half_length_m;
        const double width_m = std::sin(angle) > 0.0 ? room.half_width_m : -room.half_width_m;
        const double along = (length_m - pose.x_m) / std::cos(angle);
        const double across = (width_m - pose.y_m) / std::sin(angle);
        const double range_m = std::min(along, across) + 0.01 * random.normal();
        scan.ranges_m.push_back(range_m < scan.range_max_m ? static_cast<float>(range_m) : LaserScan::no_return);
    }
    return scan;
}

}  // namespace ddtool::test

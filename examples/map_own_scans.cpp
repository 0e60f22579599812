// Feeds the filter with scans and odometry from one's own driver, here of a robot that rolls along a room of 8 x 4 m.
#include <algorithm>
#include <cmath>
#include <iostream>
#include <numbers>

#include "ddtool/methods/method.hpp"

/// The distance from (x, 0) to the walls of the room, in the direction of the angle.
static float range_m(double x, double angle_rad) {
    const double c = std::cos(angle_rad);
    const double s = std::sin(angle_rad);
    return static_cast<float>(std::min(((c > 0.0 ? 4.0 : -4.0) - x) / c, 2.0 / std::abs(s)));
}

int main() {
    ddtool::ThreadPool threads;
    const auto filter = ddtool::make_filter({}, {}, threads);
    double degree = 0.0;
    for (int i = 0; i < 20; ++i) {
        ddtool::SensorFrame frame;
        frame.odom_from_robot = {0.1 * i, 0.0, 0.0};
        frame.scan = {.stamp_ns = i * 100'000'000LL,
                      .angle_min_rad = -std::numbers::pi,
                      .angle_increment_rad = std::numbers::pi / 180.0,
                      .range_max_m = 12.0,
                      .ranges_m = {}};
        for (std::size_t beam = 0; beam < 360; ++beam) {
            frame.scan.ranges_m.push_back(range_m(0.1 * i, frame.scan.angle_rad(beam)));
        }
        ddtool::normalise_ranges(frame.scan);             // marks zeros, NaN and ranges that are too large as ROS does
        if (const auto update = filter->update(frame)) {  // empty if the robot has hardly moved
            degree = update->degeneracy.degree;
        }
    }
    const ddtool::OccupancyGrid& map = filter->map();
    const ddtool::Cell wall{static_cast<int>(std::floor(4.0 / map.cell_size_m())), 0};
    std::cout << "x " << filter->pose().x_m << ", degree " << degree << ", wall "
              << (map.occupied(wall) || map.occupied({wall.x - 1, 0})) << '\n';
}

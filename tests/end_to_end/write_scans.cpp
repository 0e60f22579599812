// write_scans FILE: writes a log that contains scans only, without odometry and transforms.
#include "logs/messages/ros_conversions.hpp"
#include "logs/stream/ros2_writer.hpp"

int main(int /*argc*/, char** argv) {
    ddtool::LaserScan scan{.angle_min_rad = -1.5, .angle_increment_rad = 0.1, .range_max_m = 8.0, .ranges_m = {}};
    scan.ranges_m.assign(30, 2.0F);
    ddtool::Ros2Writer log(argv[1]);
    for (; scan.stamp_ns < 1'000'000'000; scan.stamp_ns += 100'000'000) {
        log.write("/scan", scan.stamp_ns, ddtool::scan_message(scan, "laser"));
    }
    log.close();
}

#include "ddtool/robot/laser_scan.hpp"

namespace ddtool {

void normalise_ranges(LaserScan& scan) {
    for (float& range : scan.ranges_m) {
        // The negated comparison is also true for NaN.
        if (!(static_cast<double>(range) >= scan.range_min_m) || range <= 0.0F) {
            range = LaserScan::invalid;
        } else if (static_cast<double>(range) > scan.range_max_m) {
            range = LaserScan::no_return;
        }
    }
}

}  // namespace ddtool

#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace ddtool {

/// One turn of a 2-D lidar. Beam i points at angle_min_rad + i * angle_increment_rad, counter-clockwise from the
/// laser's x axis; the increment is negative for a lidar that turns (or is mounted) the other way round.
struct LaserScan {
    /// The beam hit nothing: the space along it is free up to range_max_m.
    static constexpr float no_return = std::numeric_limits<float>::infinity();
    /// The measurement failed, or the echo was nearer than range_min_m: nothing is known of the space along the beam.
    static constexpr float invalid = std::numeric_limits<float>::quiet_NaN();

    std::int64_t stamp_ns = 0;  ///< of the first beam
    double angle_min_rad = 0.0;
    double angle_increment_rad = 0.0;
    double time_increment_s = 0.0;  ///< between beams; 0 where unknown, or where all beams are measured at once
    double scan_time_s = 0.0;       ///< from one scan to the next; 0 where unknown
    double range_min_m = 0.0;
    double range_max_m = 0.0;
    /// Each is a range within [range_min_m, range_max_m], no_return or invalid.
    std::vector<float> ranges_m;

    [[nodiscard]] double angle_rad(std::size_t beam) const {
        return angle_min_rad + static_cast<double>(beam) * angle_increment_rad;
    }
};

/// Brings raw ranges to the form above, by the rules of sensor_msgs/msg/LaserScan and REP 117: +inf and values above
/// range_max_m become no_return; NaN, -inf, and values below range_min_m, including 0, become invalid.
void normalise_ranges(LaserScan& scan);

}  // namespace ddtool

#pragma once

#include <cstdint>

#include "ddtool/robot/laser_scan.hpp"

namespace ddtool {

/// Seconds and nanoseconds as one number of nanoseconds. The nanoseconds may be outside of 0 to 1e9. Returns 0 for a
/// time that does not fit.
inline std::int64_t foxglove_stamp_ns(std::int64_t seconds, std::int64_t nanoseconds) {
    constexpr std::int64_t limit = 9'000'000'000;
    const bool fits = seconds > -limit && seconds < limit && nanoseconds > -limit && nanoseconds < limit;
    return fits ? seconds * 1'000'000'000 + nanoseconds : 0;
}

/// Sets the angles of a scan from the bearings of its first and last beam, because Foxglove's message has these instead
/// of an increment. The ranges must already be set.
inline void set_foxglove_angles(LaserScan& scan, double start_angle_rad, double end_angle_rad) {
    scan.angle_min_rad = start_angle_rad;
    const std::size_t beams = scan.ranges_m.size();
    scan.angle_increment_rad = beams > 1 ? (end_angle_rad - start_angle_rad) / static_cast<double>(beams - 1) : 0.0;
}

}  // namespace ddtool

#pragma once

#include <cstdint>

#include "ddtool/robot/laser_scan.hpp"

namespace ddtool::foxglove {

/// Seconds and nanoseconds, the latter possibly out of range, as one number; 0 for times that do not fit in it.
inline std::int64_t stamp_ns(std::int64_t seconds, std::int64_t nanoseconds) {
    constexpr std::int64_t limit = 9'000'000'000;
    const bool fits = seconds > -limit && seconds < limit && nanoseconds > -limit && nanoseconds < limit;
    return fits ? seconds * 1'000'000'000 + nanoseconds : 0;
}

/// Foxglove states the bearings of the first and last beam, not the increment.
inline void set_angles(LaserScan& scan, double start_angle_rad, double end_angle_rad) {
    scan.angle_min_rad = start_angle_rad;
    const std::size_t beams = scan.ranges_m.size();
    scan.angle_increment_rad = beams > 1 ? (end_angle_rad - start_angle_rad) / static_cast<double>(beams - 1) : 0.0;
}

}  // namespace ddtool::foxglove

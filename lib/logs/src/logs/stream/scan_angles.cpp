#include "logs/stream/scan_angles.hpp"

#include <cmath>
#include <numbers>

#include "base/text.hpp"

namespace ddtool {
namespace {

constexpr double full_turn_rad = 2.0 * std::numbers::pi;
constexpr double degree_in_rad = std::numbers::pi / 180.0;
/// Some drivers give a little of a turn twice, but none gives a quarter of it twice.
constexpr double most_turns = 1.25;
/// No lidar for rooms sees less than this. A scan that is narrower as degrees than this, and more than a turn as
/// radians, is as likely a wrong increment.
constexpr double least_view_degrees = 30.0;

double covered_rad(const LaserScan& scan) {
    const auto beams = static_cast<double>(scan.ranges_m.size());
    return beams < 2.0 ? 0.0 : std::abs(scan.angle_increment_rad) * (beams - 1.0);
}

bool has_directions(const LaserScan& scan) {
    return std::isfinite(scan.angle_min_rad) && std::isfinite(scan.angle_increment_rad) &&
           (scan.angle_increment_rad != 0.0 || scan.ranges_m.size() < 2);
}

}  // namespace

ScanAngles read_angles(LaserScan& scan) {
    const double view = covered_rad(scan);
    if (!has_directions(scan)) {
        return ScanAngles::impossible;
    }
    if (view <= most_turns * full_turn_rad) {
        return ScanAngles::radians;
    }
    if (view < least_view_degrees || view * degree_in_rad > most_turns * full_turn_rad) {
        return ScanAngles::impossible;
    }
    scan.angle_min_rad *= degree_in_rad;
    scan.angle_increment_rad *= degree_in_rad;
    return ScanAngles::degrees;
}

std::string angle_fault(const LaserScan& scan) {
    const std::string angles = " (angle_min " + std::to_string(scan.angle_min_rad) + ", angle_increment " +
                               std::to_string(scan.angle_increment_rad) + ")";
    if (!has_directions(scan)) {
        return "a scan whose beams have no directions" + angles;
    }
    return "a scan whose " + std::to_string(scan.ranges_m.size()) + " beams cover " +
           fixed_text(covered_rad(scan) / degree_in_rad, 0) + " degrees, expected at most a full turn" + angles;
}

}  // namespace ddtool

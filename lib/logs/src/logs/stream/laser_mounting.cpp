#include "logs/stream/laser_mounting.hpp"

#include <algorithm>
#include <cmath>

#include "logs/messages/ros_conversions.hpp"
#include "logs/stream/cloud_scan.hpp"
#include "logs/stream/scan_angles.hpp"

namespace ddtool {
namespace {

double largest_reading_m(const LaserScan& scan) {
    double largest = 0.0;
    for (const float range : scan.ranges_m) {
        if (std::isfinite(range)) {
            largest = std::max(largest, static_cast<double>(range));
        }
    }
    return largest;
}

/// Completes the limits of the range. Foxglove's messages have none, and some drivers leave them out.
void complete_limits(LaserScan& scan, const RangeRules& rules) {
    if (rules.range_max_m > 0.0) {
        scan.range_max_m = rules.range_max_m;
    }
    if (!(scan.range_min_m >= 0.0)) {
        scan.range_min_m = 0.0;
    }
    if (!(scan.range_max_m > scan.range_min_m) || !std::isfinite(scan.range_max_m)) {
        scan.range_max_m = largest_reading_m(scan);
    }
}

void mirror(LaserScan& scan) {
    scan.angle_min_rad = -scan.angle_min_rad;
    scan.angle_increment_rad = -scan.angle_increment_rad;
}

}  // namespace

bool is_same_mounting(const Pose2& a, const Pose2& b) {
    const Pose2 apart = between(a, b);
    return std::hypot(apart.x_m, apart.y_m) < 1e-3 && std::abs(apart.theta_rad) < 1e-3;
}

std::optional<std::string> place_scan(ScanReading reading, const Eigen::Isometry3d& robot_from_laser,
                                      const RangeRules& rules, SensorFrame& frame) {
    LaserScan& scan = reading.scan;
    if (scan.ranges_m.empty()) {
        return "a scan without beams";
    }
    if (read_angles(scan) == ScanAngles::impossible) {
        return angle_fault(scan);
    }
    const Eigen::Isometry3d robot_from_scan = robot_from_laser * reading.frame_from_scan;
    const bool upside_down = robot_from_scan.linear()(2, 2) < 0.0;
    if (upside_down) {
        mirror(scan);
    }
    complete_limits(scan, rules);
    rules.no_returns.apply(scan);
    normalise_ranges(scan);
    frame.robot_from_laser = to_pose2(robot_from_scan);
    frame.scan = std::move(scan);
    return std::nullopt;
}

void place_cloud(const CloudReading& cloud, const Eigen::Isometry3d& robot_from_lidar, const HeightBand& band,
                 std::size_t beams, const RangeRules& rules, SensorFrame& frame) {
    const Eigen::Isometry3d robot_from_cloud = robot_from_lidar * cloud.frame_from_cloud;
    frame.scan = cloud_scan(cloud, robot_from_cloud, band, beams);
    complete_limits(frame.scan, rules);
    rules.no_returns.apply(frame.scan);
    normalise_ranges(frame.scan);
    frame.robot_from_laser = {robot_from_cloud.translation().x(), robot_from_cloud.translation().y(), 0.0};
}

}  // namespace ddtool

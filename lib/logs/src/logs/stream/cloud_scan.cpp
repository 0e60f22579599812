#include "logs/stream/cloud_scan.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace ddtool {
namespace {

constexpr double half_turn_rad = std::numbers::pi;
constexpr double band_half_height_m = 0.3;
constexpr double above_floor_m = 0.1;
/// Nearer points are none: some drivers put a beam without return at the lidar itself.
constexpr double nearest_m = 0.05;
/// The numbers of beams to choose from. Each is a whole multiple of the next.
constexpr std::array<std::size_t, 5> beam_counts{2880, 1440, 720, 360, 180};

/// LaserScan::invalid is farther than any range.
void take_nearest(float& nearest_m, float range_m) {
    if (!std::isnan(range_m) && !(nearest_m <= range_m)) {
        nearest_m = range_m;
    }
}

/// For each beam the nearest point, or LaserScan::invalid.
std::vector<float> nearest_returns(const CloudReading& cloud, const Eigen::Isometry3d& robot_from_cloud,
                                   const HeightBand& band, std::size_t beams) {
    std::vector<float> ranges_m(beams, LaserScan::invalid);
    const double beams_per_rad = static_cast<double>(beams) / (2.0 * half_turn_rad);
    const Eigen::Matrix3d& rotation = robot_from_cloud.linear();
    const Eigen::Vector3d& origin = robot_from_cloud.translation();
    for (const Eigen::Vector3f& point : cloud.points_m) {
        const Eigen::Vector3d from_lidar = rotation * point.cast<double>();
        const double height_m = from_lidar.z() + origin.z();
        const double range_m = std::hypot(from_lidar.x(), from_lidar.y());
        if (height_m < band.min_m || height_m > band.max_m || !(range_m >= nearest_m && range_m < farthest_m)) {
            continue;
        }
        const double turned_rad = std::atan2(from_lidar.y(), from_lidar.x()) + half_turn_rad;
        const std::size_t beam = std::min(static_cast<std::size_t>(turned_rad * beams_per_rad), beams - 1);
        take_nearest(ranges_m[beam], static_cast<float>(range_m));
    }
    return ranges_m;
}

/// The nearest returns of a number of beams that the present one is a multiple of.
std::vector<float> coarser(const std::vector<float>& ranges_m, std::size_t beams) {
    const std::size_t joined = ranges_m.size() / beams;
    std::vector<float> result(beams, LaserScan::invalid);
    for (std::size_t beam = 0; beam < ranges_m.size(); ++beam) {
        take_nearest(result[beam / joined], ranges_m[beam]);
    }
    return result;
}

/// Whether the beams are not narrower than the cloud's own columns. If they are, there are empty ones all over the scan
/// between those with a point; otherwise only where a surface ends, which is at a few beams in a hundred.
bool is_filled(const std::vector<float>& ranges_m) {
    constexpr std::size_t beams_to_an_end = 10;
    std::size_t filled = 0;
    std::size_t ends = 0;
    for (std::size_t beam = 0; beam + 1 < ranges_m.size(); ++beam) {
        if (std::isfinite(ranges_m[beam])) {
            ++filled;
            ends += std::isfinite(ranges_m[beam + 1]) ? 0 : 1;
        }
    }
    return beams_to_an_end * ends <= filled;
}

std::vector<float> filled_returns(std::vector<float> ranges_m) {
    for (const std::size_t beams : beam_counts) {
        ranges_m = coarser(ranges_m, beams);
        if (is_filled(ranges_m)) {
            break;
        }
    }
    return ranges_m;
}

}  // namespace

HeightBand band_around_lidar(double lidar_height_m) {
    return {std::max(above_floor_m, lidar_height_m - band_half_height_m),
            std::max(above_floor_m + band_half_height_m, lidar_height_m) + band_half_height_m};
}

HeightBand heights_of(const CloudReading& cloud, const Eigen::Isometry3d& robot_from_lidar) {
    const Eigen::Isometry3d robot_from_cloud = robot_from_lidar * cloud.frame_from_cloud;
    HeightBand heights{INFINITY, -INFINITY};
    for (const Eigen::Vector3f& point : cloud.points_m) {
        const double height_m = (robot_from_cloud * point.cast<double>()).z();
        heights = {std::min(heights.min_m, height_m), std::max(heights.max_m, height_m)};
    }
    return heights;
}

LaserScan cloud_scan(const CloudReading& cloud, const Eigen::Isometry3d& robot_from_cloud, const HeightBand& band,
                     std::size_t beams) {
    LaserScan scan;
    scan.stamp_ns = cloud.stamp_ns;
    scan.ranges_m = beams == 0 ? filled_returns(nearest_returns(cloud, robot_from_cloud, band, beam_counts.front()))
                               : nearest_returns(cloud, robot_from_cloud, band, beams);
    scan.angle_increment_rad = 2.0 * half_turn_rad / static_cast<double>(scan.ranges_m.size());
    scan.angle_min_rad = -half_turn_rad + scan.angle_increment_rad / 2.0;
    return scan;
}

}  // namespace ddtool

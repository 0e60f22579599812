#include "robot/sweep.hpp"

#include <algorithm>
#include <cmath>

namespace ddtool {
namespace {

/// The motion between two poses of a sweep is taken as uniform. In this time an acceleration of 4 rad/s^2 turns the
/// robot by 0.05 mrad more or less than that.
constexpr double pose_every_s = 0.01;
constexpr double most_steps = 64.0;

}  // namespace

double sweep_duration_s(const LaserScan& scan, double time_increment_s) {
    return scan.ranges_m.empty() ? 0.0 : std::abs(time_increment_s) * static_cast<double>(scan.ranges_m.size() - 1);
}

std::vector<Pose2> sweep_of(const LaserScan& scan, double time_increment_s,
                            const std::function<std::optional<Pose2>(double)>& odom_from_robot) {
    const double duration_s = sweep_duration_s(scan, time_increment_s);
    const std::optional<Pose2> at_stamp = odom_from_robot(0.0);
    if (!(duration_s > 0.0) || !at_stamp) {
        return {};
    }
    const auto steps = static_cast<std::size_t>(std::clamp(std::ceil(duration_s / pose_every_s), 1.0, most_steps));
    std::vector<Pose2> sweep;
    for (std::size_t step = 0; step <= steps; ++step) {
        const double share = static_cast<double>(step) / static_cast<double>(steps);
        const std::optional<Pose2> pose = odom_from_robot(share * duration_s);
        if (!pose) {
            return {};
        }
        sweep.push_back(between(*at_stamp, *pose));
    }
    if (time_increment_s < 0.0) {
        std::ranges::reverse(sweep);
    }
    return sweep;
}

Pose2 pose_in_sweep(const std::vector<Pose2>& sweep, std::size_t beam, std::size_t beams) {
    const std::size_t steps = sweep.size() - 1;
    if (steps == 0 || beams < 2) {
        return sweep.front();
    }
    const double at = static_cast<double>(beam * steps) / static_cast<double>(beams - 1);
    const std::size_t before = std::min(static_cast<std::size_t>(at), steps - 1);
    return interpolate(sweep[before], sweep[before + 1], at - static_cast<double>(before));
}

void reverse_beams(LaserScan& scan) {
    std::ranges::reverse(scan.ranges_m);
    if (!scan.ranges_m.empty()) {
        scan.angle_min_rad = scan.angle_rad(scan.ranges_m.size() - 1);
    }
    scan.angle_increment_rad = -scan.angle_increment_rad;
}

}  // namespace ddtool

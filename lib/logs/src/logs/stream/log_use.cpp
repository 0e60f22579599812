#include "logs/stream/log_use.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "logs/stream/laser_mounting.hpp"
#include "robot/stamps.hpp"

namespace ddtool {
namespace {

void take_scan(LogUse& use, const LaserScan& scan) {
    use.fewest_beams = use.beams == 0 ? scan.ranges_m.size() : std::min(use.fewest_beams, scan.ranges_m.size());
    use.most_beams = std::max(use.most_beams, scan.ranges_m.size());
    use.field_of_view_rad = std::abs(scan.angle_rad(scan.ranges_m.size() - 1) - scan.angle_min_rad);
    use.range_max_m = scan.range_max_m;
    use.beams += scan.ranges_m.size();
    use.returns += returns_of(scan);
}

/// Notes where the laser of a scan is, unless one is known within a millimetre and a milliradian.
void take_mounting(LogUse& use, const Pose2& robot_from_laser) {
    constexpr std::size_t most_lasers = 16;
    const auto same = [&](const Pose2& known) { return is_same_mounting(known, robot_from_laser); };
    if (use.robot_from_lasers.size() < most_lasers && std::ranges::none_of(use.robot_from_lasers, same)) {
        use.robot_from_lasers.push_back(robot_from_laser);
    }
}

void take_step(LogUse& use, const SensorFrame& before, const SensorFrame& frame) {
    const double gap_s = seconds_between(before.scan.stamp_ns, frame.scan.stamp_ns);
    use.longest_gap_s = std::max(use.longest_gap_s, gap_s);
    use.stamps_back += gap_s < 0.0 ? 1 : 0;
    use.most_back_s = std::max(use.most_back_s, -gap_s);
    if (frame.lidar != 0) {
        return;
    }
    use.odometry_m += std::hypot(frame.odom_from_robot.x_m - before.odom_from_robot.x_m,
                                 frame.odom_from_robot.y_m - before.odom_from_robot.y_m);
}

}  // namespace

std::size_t returns_of(const LaserScan& scan) {
    return static_cast<std::size_t>(
        std::ranges::count_if(scan.ranges_m, [](float range_m) { return std::isfinite(range_m); }));
}

std::string why_unusable(const LogSummary& summary, std::size_t returns) {
    if (returns > 0) {
        return "";
    }
    const std::string first =
        summary.first_problems.empty() ? "" : "; the first problem: " + summary.first_problems.front();
    return summary.scans == 0 ? "none of its scans can be used" + first
                              : "no beam of its " + std::to_string(summary.scans) + " scans has a return" + first;
}

LogUse use_of(LogStream& log, const std::function<void(double)>& on_progress) {
    LogUse use;
    std::map<std::size_t, SensorFrame> before;  // of each lidar
    while (std::optional<SensorFrame> frame = log.next()) {
        take_scan(use, frame->scan);
        if (const auto known = before.find(frame->lidar); known != before.end()) {
            take_step(use, known->second, *frame);
        }
        use.first_ns = before.empty() ? frame->scan.stamp_ns : use.first_ns;
        use.last_ns = frame->scan.stamp_ns;
        take_mounting(use, frame->robot_from_laser);
        use.with_ground_truth += frame->world_from_robot ? 1 : 0;
        before.insert_or_assign(frame->lidar, std::move(*frame));
        on_progress(log.fraction_read());
    }
    use.summary = log.summary();
    use.lidars = before.size();
    return use;
}

}  // namespace ddtool

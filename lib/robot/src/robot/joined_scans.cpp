#include "ddtool/robot/joined_scans.hpp"
#include "robot/stamps.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace ddtool {
namespace {}  // namespace

std::optional<SensorFrame> JoinedScans::next() {
    while (std::optional<SensorFrame> frame = source_.next()) {
        step_ = std::max(step_, frame->odom_step);
        if (!leads(*frame)) {
            const std::size_t lidar = frame->lidar;
            latest_.insert_or_assign(lidar, std::move(*frame));
            continue;
        }
        frame->odom_step = std::exchange(step_, OdometryStep::measured);
        for (const auto& [lidar, other] : latest_) {
            if (lidar != frame->lidar &&
                std::abs(seconds_between(other.scan.stamp_ns, frame->scan.stamp_ns)) <= oldest_s) {
                frame->joined.push_back(other);
            }
        }
        return frame;
    }
    return std::nullopt;
}

bool JoinedScans::leads(const SensorFrame& frame) {
    const std::int64_t stamp_ns = frame.scan.stamp_ns;
    if (!led_ns_) {
        led_ns_ = stamp_ns;
    }
    if (frame.lidar == 0 || seconds_between(*led_ns_, stamp_ns) > silent_s) {
        leader_ = frame.lidar;
    }
    if (frame.lidar != leader_) {
        return false;
    }
    led_ns_ = stamp_ns;
    return true;
}

}  // namespace ddtool

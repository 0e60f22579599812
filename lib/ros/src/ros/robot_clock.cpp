#include "ros/robot_clock.hpp"

namespace ddtool {
namespace {

/// A stamp that lies farther back has not been delayed: the clock has been set back.
constexpr std::int64_t farthest_back_ns = 1'000'000'000;

}  // namespace

void RobotClock::heard(std::int64_t stamp_ns, std::int64_t arrived_ns) {
    if (simulated_) {
        return;
    }
    const std::lock_guard lock(mutex_);
    const std::int64_t expected_ns = has_base_ ? at(arrived_ns) : 0;
    if (!has_base_ || stamp_ns > expected_ns || stamp_ns < expected_ns - farthest_back_ns) {
        has_base_ = true;
        base_ns_ = stamp_ns;
        base_steady_ns_ = arrived_ns;
    }
}

void RobotClock::told(std::int64_t time_ns) {
    const std::lock_guard lock(mutex_);
    has_base_ = true;
    base_ns_ = time_ns;
}

std::int64_t RobotClock::now_ns(std::int64_t steady_ns) const {
    const std::lock_guard lock(mutex_);
    return simulated_ || !has_base_ ? base_ns_ : at(steady_ns);
}

bool RobotClock::is_told() const {
    const std::lock_guard lock(mutex_);
    return has_base_;
}

}  // namespace ddtool

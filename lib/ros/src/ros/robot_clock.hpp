#pragma once

#include <cstdint>
#include <mutex>

namespace ddtool {

/// What time it is on the robot, by the stamps of its messages: they go on with the steady clock of this machine, so
/// that the two machines need not have their clocks set alike. A simulator's time goes on with its /clock alone. Any
/// thread may use it.
class RobotClock {
public:
    explicit RobotClock(bool simulated) : simulated_(simulated) {}

    /// A message with this stamp has arrived. Times in nanoseconds, `arrived_ns` of the steady clock.
    void heard(std::int64_t stamp_ns, std::int64_t arrived_ns);
    /// The simulator has told its time.
    void told(std::int64_t time_ns);
    /// The time now; 0 before the first message.
    [[nodiscard]] std::int64_t now_ns(std::int64_t steady_ns) const;
    /// Whether the simulator has told its time.
    [[nodiscard]] bool is_told() const;

private:
    [[nodiscard]] std::int64_t at(std::int64_t steady_ns) const { return base_ns_ + (steady_ns - base_steady_ns_); }

    bool simulated_;
    mutable std::mutex mutex_;
    bool has_base_ = false;
    std::int64_t base_ns_ = 0;
    std::int64_t base_steady_ns_ = 0;
};

}  // namespace ddtool

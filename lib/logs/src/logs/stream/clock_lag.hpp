#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace ddtool {

/// How far the stamps of a topic lag behind the times of its recording, along the log; and from when to when they are.
/// Memory does not grow with the log.
class ClockLag {
public:
    void add(std::int64_t stamp_ns, std::int64_t recorded_ns);
    /// That of a topic whose stamps are its times of recording, between the first and the last of these.
    [[nodiscard]] static ClockLag of_recording(std::int64_t first_ns, std::int64_t last_ns);

    /// Whether the stamps of the two topics, the first moved on by `offset_s`, have a moment in common.
    [[nodiscard]] static bool overlap(const ClockLag& a, const ClockLag& b, double offset_s);
    /// By how many seconds the clock of `b` is ahead of that of `a`: the median of what the times of recording say,
    /// each message of `b` compared with the one of `a` that was recorded next to it. Nullopt if that is not the same
    /// along the log, to a tenth of a second, or if there are fewer than ten messages.
    [[nodiscard]] static std::optional<double> offset_s(const ClockLag& a, const ClockLag& b);

private:
    struct Sample {
        double recorded_s = 0.0;
        double ahead_s = 0.0;  ///< stamp minus time of recording
    };

    std::vector<Sample> samples_;
    std::size_t every_ = 1;  ///< one message of this many is kept
    std::size_t seen_ = 0;
    std::int64_t first_ns_ = 0;  ///< the earliest and the latest stamp
    std::int64_t last_ns_ = 0;
};

}  // namespace ddtool

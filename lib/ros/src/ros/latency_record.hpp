#pragma once

#include <array>
#include <cstddef>

namespace ddtool {

/// How long something took, many times: counts in steps of one part in ten, so that it needs the same memory however
/// long a run is. For one thread at a time.
class LatencyRecord {
public:
    void add(double seconds);
    [[nodiscard]] std::size_t count() const { return count_; }
    /// What the given share of them took at most, in seconds, one part in ten too much at most; 0 if there are none.
    [[nodiscard]] double quantile_s(double share) const;

private:
    static constexpr std::size_t steps = 160;

    std::array<std::size_t, steps> counts_{};
    std::size_t count_ = 0;
};

}  // namespace ddtool

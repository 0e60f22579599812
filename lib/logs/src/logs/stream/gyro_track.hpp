#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>

namespace ddtool {

/// The turns that a gyro measured: its turn rates, added up over time. Where it was silent for longer than
/// longest_gap_s, the turn is unknown. If its stamps step back, what was before is forgotten.
class GyroTrack {
public:
    static constexpr double longest_gap_s = 0.25;
    static constexpr std::size_t most_samples = 1 << 16;

    void add(std::int64_t stamp_ns, double rate_rad_per_s);
    /// Whether there is a rate at this time or later.
    [[nodiscard]] bool reaches(std::int64_t stamp_ns) const;
    /// The turn from one time to a later one, not wrapped; nullopt where it is unknown.
    [[nodiscard]] std::optional<double> turn_rad(std::int64_t from_ns, std::int64_t to_ns) const;

private:
    struct Sample {
        std::int64_t stamp_ns = 0;
        double rate_rad_per_s = 0.0;
        double heading_rad = 0.0;
        std::size_t piece = 0;  ///< rises after each gap
    };
    struct Heading {
        double rad = 0.0;
        std::size_t piece = 0;
    };

    [[nodiscard]] std::optional<Heading> heading_at(std::int64_t stamp_ns) const;

    std::deque<Sample> samples_;
};

}  // namespace ddtool

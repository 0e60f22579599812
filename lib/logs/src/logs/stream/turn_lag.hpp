#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "ddtool/robot/laser_scan.hpp"

namespace ddtool {

/// How a lidar turned from scan to scan, in the first part of a log. Memory and time do not grow with the log: after
/// most_pairs pairs of scans that turn, or most_compared pairs in all, nothing is added.
class ScanTurns {
public:
    static constexpr std::size_t most_pairs = 2000;
    static constexpr std::size_t most_compared = 20'000;

    /// One step from a scan to the next, with their stamps.
    struct Pair {
        std::int64_t from_ns = 0;
        std::int64_t to_ns = 0;
        double turn_rad = 0.0;
    };

    /// \param scan ranges as logged
    void add(const LaserScan& scan);
    [[nodiscard]] const std::vector<Pair>& pairs() const { return pairs_; }
    [[nodiscard]] bool is_full() const { return pairs_.size() >= most_pairs || compared_ >= most_compared; }

private:
    std::optional<LaserScan> before_;
    std::vector<Pair> pairs_;
    std::size_t compared_ = 0;
    bool turned_ = false;  ///< in the last pair
};

/// The heading of a moving frame along the log, in bounded memory.
class HeadingTrack {
public:
    static constexpr std::size_t most_headings = 100'000;

    void add(std::int64_t stamp_ns, double heading_rad);
    /// The turn between two moments, in radians and not wrapped; nullopt where there is no heading on both sides within
    /// half a second.
    [[nodiscard]] std::optional<double> turn_rad(double from_s, double to_s) const;
    /// The moment from which the seconds above count.
    [[nodiscard]] std::int64_t origin_ns() const { return origin_ns_; }

private:
    [[nodiscard]] std::optional<double> heading_at(double at_s) const;

    std::int64_t origin_ns_ = 0;
    std::vector<std::pair<double, double>> headings_;  ///< seconds, radians without wrapping
    double last_rad_ = 0.0;
};

/// By how much the stamps of odometry are late against those of the scans.
struct TurnLag {
    /// As if all beams of a scan were measured at its stamp. Where they are measured one after the other, what the
    /// turns show is the moment of the middle beam, by which this is too large.
    double late_s = 0.0;
    double sigma_s = 0.0;     ///< standard deviation
    double scale = 1.0;       ///< the scans' turns divided by the odometry's; negative for a lidar upside down
    double share = 0.0;       ///< of the squares of the scans' turns that the odometry does not explain, at late_s
    std::size_t turning = 0;  ///< pairs of scans that turn
    /// Whether the lag is sure to differ from 0, by more than 20 ms and four standard deviations.
    [[nodiscard]] bool is_significant() const;
};

/// The lag at which the turns of the odometry fit those of the scans best, in the sense of least squares without
/// outliers, and its uncertainty from the curvature of their sum. Sought up to half a second either way.
/// \param ahead_s added to the scans' stamps first, for clocks that are far apart
/// Nullopt if it is not well determined: too few turns, no clear best, or not the same in both halves of the log.
std::optional<TurnLag> turn_lag(const ScanTurns& scans, const HeadingTrack& odometry, double ahead_s);

}  // namespace ddtool

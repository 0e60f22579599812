#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <vector>

#include "ddtool/robot/sensor_stream.hpp"

namespace ddtool {

/// Finds out from the scans how long a lidar takes for its beams, and in which order it measures them.
///
/// A scan that is taken while the robot turns or drives is distorted, and one that is taken a moment before, while the
/// robot moved otherwise, is distorted otherwise. The two agree best if both are straightened by the right times. Each
/// candidate straightens such pairs of scans, the second is laid on the first (point to line, Chen and Medioni 1992),
/// and what remains between them is compared. A candidate replaces the one in use when, over all pairs so far, it
/// leaves distinctly less.
///
/// For one thread at a time. The work is bounded: after most_pairs nothing more is compared.
class SweepTrial {
public:
    static constexpr std::size_t most_pairs = 150;
    static constexpr std::size_t least_pairs = 8;
    /// What a candidate has to leave less, as the mean over the pairs of the logarithm of the ratio: 5 %. Less than
    /// that would not matter.
    static constexpr double least_gain = 0.05;
    /// And as a multiple of the standard error of that mean. The pairs of one turn have errors in common, so that two
    /// or three would not be enough.
    static constexpr double least_deviations = 5.0;

    /// \param candidates how many; the first is used until another one proves better
    explicit SweepTrial(std::size_t candidates) : candidates_(candidates) {}

    /// The next scan.
    /// \param sweeps SensorFrame::sweep by each candidate
    void add(const SensorFrame& frame, const std::vector<std::vector<Pose2>>& sweeps);

    /// The candidate in use.
    [[nodiscard]] std::size_t chosen() const { return chosen_; }
    /// Pairs of scans that were compared.
    [[nodiscard]] std::size_t pairs() const { return costs_.size(); }
    /// Whether the scans confirm the candidate in use against candidate `other`, by the rule above.
    [[nodiscard]] bool is_better_than(std::size_t other) const { return is_better(chosen_, other); }

private:
    struct Scan {
        std::int64_t stamp_ns = 0;
        Pose2 odom_from_robot;
        Pose2 longest_motion;                       ///< during the scan, by the candidate with the longest motion
        std::vector<std::vector<Point2>> points_m;  ///< by candidate, in the order of the beams
    };

    [[nodiscard]] const Scan* partner_of(const Scan& scan) const;
    void compare(const Scan& first, const Scan& second);
    [[nodiscard]] bool is_better(std::size_t candidate, std::size_t other) const;

    std::size_t candidates_;
    std::size_t chosen_ = 0;
    std::deque<Scan> latest_;
    std::vector<std::vector<double>> costs_;  ///< by pair and candidate, in metres
};

}  // namespace ddtool

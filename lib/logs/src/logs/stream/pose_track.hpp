#pragma once

#include <cstdint>
#include <deque>
#include <optional>

#include "ddtool/robot/trajectory.hpp"

namespace ddtool {

/// The latest poses of a moving frame in the order of the log. Stamps usually rise, but may step back; each step back
/// begins a new piece of time. If several intervals contain a stamp, the latest in the log is used.
class PoseTrack {
public:
    static constexpr std::size_t max_poses = 1 << 16;
    static constexpr double longest_extension_s = 0.25;

    void add(const StampedPose& pose);
    /// Whether there is a pose with exactly this stamp after the last pose with an earlier one.
    [[nodiscard]] bool contains(std::int64_t stamp_ns) const;
    /// The pose interpolated in the latest interval that contains the stamp; nullopt if no interval contains it.
    [[nodiscard]] std::optional<Pose2> at(std::int64_t stamp_ns) const;
    /// The same, but up to longest_extension_s beyond the poses, where the latest motion is taken to go on.
    [[nodiscard]] std::optional<Pose2> extended_at(std::int64_t stamp_ns) const;
    /// The pose that is nearest in time, and of equally near ones the latest; nullopt if there are no poses.
    [[nodiscard]] std::optional<StampedPose> nearest(std::int64_t stamp_ns) const;

private:
    std::deque<StampedPose> poses_;
};

}  // namespace ddtool

#pragma once

#include <cstdint>
#include <deque>
#include <optional>

#include "ddtool/robot/trajectory.hpp"

namespace ddtool {

/// The latest poses of a moving frame in the order of the log, where stamps usually rise but may step back. At each
/// step back time begins anew, so the latest interval that holds a stamp is the one that counts.
class PoseTrack {
public:
    static constexpr std::size_t max_poses = 1 << 16;

    void add(const StampedPose& pose);
    /// Is there a pose of this very stamp since the last one before it?
    [[nodiscard]] bool contains(std::int64_t stamp_ns) const;
    /// Interpolated within the latest interval that holds the stamp; none outside of all.
    [[nodiscard]] std::optional<Pose2> at(std::int64_t stamp_ns) const;
    /// The pose nearest in time, the latest of equals; none while there are no poses.
    [[nodiscard]] std::optional<StampedPose> nearest(std::int64_t stamp_ns) const;

private:
    std::deque<StampedPose> poses_;
};

}  // namespace ddtool

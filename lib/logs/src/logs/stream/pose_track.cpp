#include "logs/stream/pose_track.hpp"

#include <algorithm>
#include <cmath>

namespace ddtool {
namespace {

/// The time from `from_ns` to a stamp that is not earlier. Computed without signs, because the stamps of a damaged log
/// may differ by more than a signed 64-bit number can hold.
double elapsed_ns(std::int64_t from_ns, std::int64_t to_ns) {
    return static_cast<double>(static_cast<std::uint64_t>(to_ns) - static_cast<std::uint64_t>(from_ns));
}

}  // namespace

void PoseTrack::add(const StampedPose& pose) {
    poses_.push_back(pose);
    if (poses_.size() > max_poses) {
        poses_.pop_front();
    }
}

bool PoseTrack::contains(std::int64_t stamp_ns) const {
    const auto found = std::find_if(poses_.rbegin(), poses_.rend(),
                                    [&](const StampedPose& pose) { return pose.stamp_ns <= stamp_ns; });
    return found != poses_.rend() && found->stamp_ns == stamp_ns;
}

std::optional<Pose2> PoseTrack::at(std::int64_t stamp_ns) const {
    for (std::size_t i = poses_.size(); i-- > 0;) {
        const StampedPose& after = poses_[i];
        if (after.stamp_ns == stamp_ns) {
            return after.pose;
        }
        if (i > 0 && poses_[i - 1].stamp_ns < stamp_ns && stamp_ns < after.stamp_ns) {
            const StampedPose& before = poses_[i - 1];
            return interpolate(before.pose, after.pose,
                               elapsed_ns(before.stamp_ns, stamp_ns) / elapsed_ns(before.stamp_ns, after.stamp_ns));
        }
    }
    return std::nullopt;
}

std::optional<Pose2> PoseTrack::extended_at(std::int64_t stamp_ns) const {
    if (std::optional<Pose2> pose = at(stamp_ns)) {
        return pose;
    }
    if (poses_.empty() || stamp_ns < poses_.back().stamp_ns ||
        elapsed_ns(poses_.back().stamp_ns, stamp_ns) > 1e9 * longest_extension_s) {
        return std::nullopt;
    }
    const StampedPose& last = poses_.back();
    const auto beyond_ns = static_cast<std::int64_t>(elapsed_ns(last.stamp_ns, stamp_ns));
    const std::optional<Pose2> as_long_before = at(last.stamp_ns - beyond_ns);
    return as_long_before ? last.pose * between(*as_long_before, last.pose) : last.pose;
}

std::optional<StampedPose> PoseTrack::nearest(std::int64_t stamp_ns) const {
    const auto apart = [&](const StampedPose& pose) {
        return std::abs(static_cast<double>(pose.stamp_ns) - static_cast<double>(stamp_ns));
    };
    const auto found =
        std::min_element(poses_.rbegin(), poses_.rend(),
                         [&](const StampedPose& a, const StampedPose& b) { return apart(a) < apart(b); });
    return found == poses_.rend() ? std::nullopt : std::optional(*found);
}

}  // namespace ddtool

#include "logs/stream/track_survey.hpp"

#include <algorithm>
#include <cmath>

#include "base/median.hpp"
#include "ddtool/robot/pose2.hpp"
#include "logs/messages/ros_conversions.hpp"
#include "robot/stamps.hpp"

namespace ddtool {
namespace {

constexpr double moved_m = 0.02;
constexpr double moved_rad = 0.02;
constexpr std::size_t most_intervals = 1000;

}  // namespace

void TrackSurvey::add(const PoseReading& reading, std::int64_t recorded_ns, std::uint16_t connection) {
    add(reading, recorded_ns);
    if (reading.has_rotation) {
        const std::size_t path = interleaved_.add({reading.stamp_ns, to_pose2(reading.frame_from_child)}, connection);
        if (path < InterleavedPaths::most_paths) {
            paths_.resize(std::max(paths_.size(), path + 1));
            paths_[path].add(reading, recorded_ns);
        }
    }
}

std::vector<TrackSurvey> TrackSurvey::paths() const {
    return interleaved_.are_interleaved() ? paths_ : std::vector<TrackSurvey>{};
}

void TrackSurvey::add(const PoseReading& reading, std::int64_t recorded_ns) {
    if (!reading.has_rotation) {
        ++without_rotation_;
        return;
    }
    ++usable_;
    stamps_.add(reading.stamp_ns, reading.has_stamp, recorded_ns);
    if (reading.has_stamp) {
        clock_.add(reading.stamp_ns, recorded_ns);
    }
    if (last_ns_ && intervals_s_.size() < most_intervals) {
        intervals_s_.push_back(seconds_between(*last_ns_, reading.stamp_ns));
    }
    last_ns_ = reading.stamp_ns;
    first_ = first_.value_or(reading.frame_from_child);
    const Pose2 pose = to_pose2(reading.frame_from_child);
    heading_.add(reading.stamp_ns, pose.theta_rad);
    way_.add({reading.stamp_ns, pose});
    const Pose2 moved = to_pose2(first_->inverse() * reading.frame_from_child);
    moves_ = moves_ || std::hypot(moved.x_m, moved.y_m) > moved_m || std::abs(moved.theta_rad) > moved_rad;
}

double TrackSurvey::usual_interval_s() const { return std::max(upper_median(intervals_s_), 0.0); }

}  // namespace ddtool

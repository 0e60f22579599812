#include "logs/stream/track_survey.hpp"

#include <cmath>

#include "ddtool/robot/pose2.hpp"
#include "logs/messages/ros_conversions.hpp"

namespace ddtool {
namespace {

constexpr double moved_m = 0.02;
constexpr double moved_rad = 0.02;

}  // namespace

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
    first_ = first_.value_or(reading.frame_from_child);
    const Pose2 moved = to_pose2(first_->inverse() * reading.frame_from_child);
    moves_ = moves_ || std::hypot(moved.x_m, moved.y_m) > moved_m || std::abs(moved.theta_rad) > moved_rad;
}

}  // namespace ddtool

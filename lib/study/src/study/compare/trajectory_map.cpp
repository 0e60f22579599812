#include "study/compare/trajectory_map.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace ddtool::compare {
namespace {

constexpr double step_m = 0.2;
constexpr double step_rad = 0.2;

bool has_moved(const Pose2& from, const Pose2& to) {
    const Pose2 motion = between(from, to);
    return std::hypot(motion.x_m, motion.y_m) >= step_m || std::abs(motion.theta_rad) >= step_rad;
}

}  // namespace

TrajectoryMap::TrajectoryMap(Trajectory trajectory) : sorted_(std::move(trajectory)) {
    std::stable_sort(sorted_.begin(), sorted_.end(),
                     [](const StampedPose& a, const StampedPose& b) { return a.stamp_ns < b.stamp_ns; });
}

void TrajectoryMap::add(const SensorFrame& frame) {
    const std::optional<Pose2> pose = pose_at(sorted_, frame.scan.stamp_ns);
    if (pose && (!last_ || has_moved(*last_, *pose))) {
        inserter_.insert(grid_, scan_points(frame, ScanPointsSettings{}), *pose);
        last_ = pose;
    }
}

}  // namespace ddtool::compare

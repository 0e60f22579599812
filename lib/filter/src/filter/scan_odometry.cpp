#include "ddtool/filter/scan_odometry.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "robot/sweep.hpp"

namespace ddtool {
namespace {

/// Driven distance after which the map is replaced by its successor.
constexpr double map_length_m = 5.0;
/// Standard deviations of the pose, from one scan to the next, about the prediction at constant speed.
constexpr PosePrior surprise{.sigma_along_m = 0.1, .sigma_across_m = 0.1, .sigma_turn_rad = 0.1};

/// The motion at the same speed in a time of step_ns. If one of the two times is not positive, the motion is returned
/// unchanged.
Pose2 at_same_speed(const Pose2& motion, std::int64_t its_ns, std::int64_t step_ns) {
    constexpr double longest = 3.0;  // limit on the ratio of the times: after a gap in the log the speed is unknown
    if (its_ns <= 0 || step_ns <= 0) {
        return motion;
    }
    const double share = std::min(static_cast<double>(step_ns) / static_cast<double>(its_ns), longest);
    return {share * motion.x_m, share * motion.y_m, share * motion.theta_rad};
}

}  // namespace

ScanOdometryStream::ScanOdometryStream(SensorStream& source, const RbpfSettings& settings)
    : source_(source),
      settings_(settings),
      matcher_(settings.matcher, settings.grid.cell_size_m),
      map_(settings.grid),
      next_map_(settings.grid) {}

std::optional<SensorFrame> ScanOdometryStream::next() {
    std::optional<SensorFrame> frame = source_.next();
    if (!frame) {
        return frame;
    }
    place(*frame);
    if (started_) {
        const Pose2 found = match(*frame, scan_points(*frame, settings_.points));
        motion_ = between(pose_, found);
        step_ns_ = frame->scan.stamp_ns - stamp_ns_;
        pose_ = found;
        place(*frame);
    }
    const ScanPoints points = scan_points(*frame, settings_.points);
    const Pose2 since = between(entered_, pose_);
    if (!started_ || std::hypot(since.x_m, since.y_m) >= settings_.insert_distance_m ||
        std::abs(since.theta_rad) >= settings_.insert_turn_rad) {
        enter(points);
    }
    started_ = true;
    stamp_ns_ = frame->scan.stamp_ns;
    frame->odom_from_robot = pose_;
    for (SensorFrame& other : frame->joined) {
        other.odom_from_robot = pose_ * other.odom_from_robot;
    }
    return frame;
}

/// Places the beams of the frame and of those joined with it, in the robot's frame at the stamp of the first: the
/// motion goes on as between the last two scans.
void ScanOdometryStream::place(SensorFrame& frame) const {
    const auto moved_after = [&](double seconds) -> std::optional<Pose2> {
        return step_ns_ > 0 && seconds > 0.0 ? at_same_speed(motion_, step_ns_, std::llround(1e9 * seconds)) : Pose2{};
    };
    frame.odom_from_robot = {};
    frame.sweep = sweep_of(frame.scan, frame.scan.time_increment_s, moved_after);
    for (SensorFrame& other : frame.joined) {
        const std::int64_t since_ns = frame.scan.stamp_ns - other.scan.stamp_ns;
        const Pose2 since = at_same_speed(motion_, step_ns_, std::abs(since_ns));
        other.odom_from_robot = since_ns == 0 || step_ns_ <= 0 ? Pose2{} : since_ns > 0 ? inverse(since) : since;
        other.sweep = sweep_of(other.scan, other.scan.time_increment_s, moved_after);
    }
}

Pose2 ScanOdometryStream::match(const SensorFrame& frame, const ScanPoints& points) {
    const Pose2 predicted = pose_ * at_same_speed(motion_, step_ns_, frame.scan.stamp_ns - stamp_ns_);
    const MatchPoints match_points(points, settings_.grid.cell_size_m);
    const ScanMatch found = matcher_.match(map_, match_points, predicted, surprise);
    return found.accepted() ? found.pose : predicted;
}

void ScanOdometryStream::enter(const ScanPoints& points) {
    map_length_m_ += distance_m(entered_, pose_);
    if (map_length_m_ > map_length_m) {
        map_ = std::exchange(next_map_, OccupancyGrid(settings_.grid));
        map_length_m_ = 0.0;
    }
    inserter_.insert(map_, points, pose_);
    inserter_.insert(next_map_, points, pose_);
    entered_ = pose_;
}

}  // namespace ddtool

#include "ddtool/filter/scan_odometry.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "robot/sweep.hpp"

namespace ddtool {
namespace {

/// Driven distance after which the map is replaced by its successor.
constexpr double map_length_m = 5.0;
/// Scans that are kept for the case that one must be matched: as many as a map of that length has where the robot turns
/// a lot.
constexpr std::size_t most_seen = 64;
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
    const Pose2 logged = frame->odom_from_robot;
    if (started_) {
        const std::int64_t step_ns = frame->scan.stamp_ns - stamp_ns_;
        place(*frame, logged);
        Pose2 found = logged;
        if (frame->odom_step == OdometryStep::measured) {
            found = matched_ ? pose_ * between(logged_, logged) : logged;
        } else {
            found =
                match(*frame, frame->odom_step == OdometryStep::guessed ? between(logged_, logged)
                                                                        : at_same_speed(motion_, step_ns_, step_ns));
            matched_ = true;
        }
        motion_ = between(pose_, found);
        step_ns_ = step_ns;
        pose_ = found;
        place(*frame, logged);
    } else {
        pose_ = frame->odom_step == OdometryStep::measured ? logged : Pose2{};
        matched_ = pose_ != logged;
    }
    logged_ = logged;
    stamp_ns_ = frame->scan.stamp_ns;
    const Pose2 since = between(remembered_, pose_);
    if (!started_ || std::hypot(since.x_m, since.y_m) >= settings_.insert_distance_m ||
        std::abs(since.theta_rad) >= settings_.insert_turn_rad) {
        remember(*frame);
    }
    started_ = true;
    if (matched_) {
        for (SensorFrame& other : frame->joined) {
            other.odom_from_robot = pose_ * between(logged, other.odom_from_robot);
        }
    }
    frame->odom_from_robot = pose_;
    return frame;
}

/// Where the odometry does not tell the motion before this frame, it does not tell that during it either: the motion is
/// taken to go on as between the last two scans.
void ScanOdometryStream::place(SensorFrame& frame, const Pose2& logged) const {
    if (frame.odom_step == OdometryStep::measured) {
        return;
    }
    const auto moved_after = [&](double seconds) -> std::optional<Pose2> {
        return step_ns_ > 0 && seconds > 0.0 ? at_same_speed(motion_, step_ns_, std::llround(1e9 * seconds)) : Pose2{};
    };
    frame.sweep = sweep_of(frame.scan, frame.scan.time_increment_s, moved_after);
    for (SensorFrame& other : frame.joined) {
        const std::int64_t since_ns = frame.scan.stamp_ns - other.scan.stamp_ns;
        const Pose2 since = at_same_speed(motion_, step_ns_, std::abs(since_ns));
        const Pose2 step = since_ns == 0 || step_ns_ <= 0 ? Pose2{} : since_ns > 0 ? inverse(since) : since;
        other.odom_from_robot = logged * step;
        other.sweep = sweep_of(other.scan, other.scan.time_increment_s, moved_after);
    }
}

Pose2 ScanOdometryStream::match(const SensorFrame& frame, const Pose2& step) {
    enter_remembered();
    const Pose2 predicted = pose_ * step;
    const MatchPoints match_points(scan_points(frame, settings_.points), settings_.grid.cell_size_m);
    const ScanMatch found = matcher_.match(map_, match_points, predicted, surprise);
    return found.accepted() ? found.pose : predicted;
}

void ScanOdometryStream::remember(const SensorFrame& frame) {
    seen_.push_back({frame, pose_});
    if (seen_.size() > most_seen) {
        seen_.pop_front();
    }
    remembered_ = pose_;
}

void ScanOdometryStream::enter_remembered() {
    for (; !seen_.empty(); seen_.pop_front()) {
        const Seen& seen = seen_.front();
        map_length_m_ += distance_m(entered_, seen.pose);
        if (map_length_m_ > map_length_m) {
            map_ = std::exchange(next_map_, OccupancyGrid(settings_.grid));
            map_length_m_ = 0.0;
        }
        const ScanPoints points = scan_points(seen.frame, settings_.points);
        inserter_.insert(map_, points, seen.pose);
        inserter_.insert(next_map_, points, seen.pose);
        entered_ = seen.pose;
    }
}

}  // namespace ddtool

#include "logs/stream/frame_watch.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/median.hpp"
#include "base/text.hpp"
#include "logs/stream/laser_mounting.hpp"
#include "logs/stream/scan_change.hpp"
#include "robot/stamps.hpp"

namespace ddtool {
namespace {

constexpr double still_m = 1e-3;
constexpr double still_rad = 1e-3;
constexpr std::size_t stuck_places = 3;
constexpr double least_pause_s = 2.0;
constexpr double usual_scan_intervals = 10.0;
constexpr double pause_motion_m = 1.0;
constexpr double pause_motion_rad = 1.0;
constexpr std::size_t intervals_kept = 101;

bool is_nearer(const Pose2& a, const Pose2& b, double least_m, double least_rad) {
    const Pose2 apart = between(a, b);
    return std::hypot(apart.x_m, apart.y_m) <= least_m && std::abs(apart.theta_rad) <= least_rad;
}

}  // namespace

void FrameWatch::add(SensorFrame frame) {
    const StrayStamps::Found found = strays_.add(frame.scan.stamp_ns, frame.lidar);
    if (const auto suspect = suspects_.find(frame.lidar); suspect != suspects_.end()) {
        if (!found.before_was_stray) {
            watch(std::move(suspect->second));
        }
        suspects_.erase(suspect);
    }
    if (found.is_suspect) {
        suspects_.emplace(frame.lidar, std::move(frame));
    } else {
        watch(std::move(frame));
    }
}

void FrameWatch::watch(SensorFrame frame) {
    first_ns_ = first_ns_.value_or(frame.scan.stamp_ns);
    check_pause(frame);
    const bool is_still = frame.odom_step == OdometryStep::measured && before_ &&
                          is_nearer(still_.pose, frame.odom_from_robot, still_m, still_rad);
    before_ = {frame.scan.stamp_ns, frame.odom_from_robot};
    if (is_still) {
        stand(std::move(frame));
    } else {
        move(std::move(frame));
    }
}

void FrameWatch::stand(SensorFrame frame) {
    const std::size_t passed = places_passed(frame);
    waiting_.push_back(std::move(frame));
    if (passed >= stuck_places || stuck_scans_ > 0) {
        for (SensorFrame& waited : waiting_) {
            waited.odom_step = OdometryStep::unknown;
        }
        stuck_scans_ += waiting_.size();
        release_waiting();
    } else if (waiting_.size() > std::min(most_held_, passed > 0 ? most_waiting : unchanged_waiting)) {
        ready_.push_back(std::move(waiting_.front()));
        waiting_.pop_front();
    }
}

/// By the laser of this frame.
std::size_t FrameWatch::places_passed(const SensorFrame& frame) {
    const auto same = [&](const Place& place) {
        return is_same_mounting(place.robot_from_laser, frame.robot_from_laser);
    };
    const auto place = std::ranges::find_if(places_, same);
    if (place == places_.end()) {
        places_.push_back({frame.robot_from_laser, frame.scan.ranges_m});
        return 0;
    }
    if (is_another_view(place->ranges_m, frame.scan.ranges_m)) {
        place->ranges_m = frame.scan.ranges_m;
        ++place->passed;
    }
    return place->passed;
}

/// The step out of a stuck part may contain what the wheels counted meanwhile, so that it is unknown as well. Where the
/// odometry starts again, it had already stopped if the view changed while it stood.
void FrameWatch::move(SensorFrame frame) {
    const bool has_changed = std::ranges::any_of(places_, [](const Place& place) { return place.passed > 0; });
    if (frame.odom_step == OdometryStep::unknown && has_changed) {
        for (SensorFrame& waited : waiting_) {
            waited.odom_step = OdometryStep::unknown;
        }
    }
    release_waiting();
    if (stuck_scans_ > 0) {
        frame.odom_step = OdometryStep::unknown;
        end_stuck_part();
    }
    still_ = {frame.scan.stamp_ns, frame.odom_from_robot};
    places_ = {{frame.robot_from_laser, frame.scan.ranges_m}};
    ready_.push_back(std::move(frame));
}

void FrameWatch::release_waiting() {
    std::ranges::move(waiting_, std::back_inserter(ready_));
    waiting_.clear();
}

void FrameWatch::end_stuck_part() {
    findings_.push_back("the odometry is stuck from " + at(still_.stamp_ns) + " to " + at(before_->stamp_ns) + " (" +
                        std::to_string(stuck_scans_) +
                        " scans), although the scans change; the motion there is worked out from the scans");
    stuck_scans_ = 0;
}

void FrameWatch::end() {
    for (auto& [lidar, suspect] : suspects_) {
        watch(std::move(suspect));
    }
    suspects_.clear();
    release_waiting();
    if (std::string finding = strays_.finding(); !finding.empty()) {
        findings_.push_back(std::move(finding));
    }
    if (stuck_scans_ > 0) {
        end_stuck_part();
    }
}

std::optional<double> FrameWatch::usual_interval_s() const {
    if (intervals_s_.empty()) {
        return std::nullopt;
    }
    return upper_median({intervals_s_.begin(), intervals_s_.end()});
}

void FrameWatch::check_pause(const SensorFrame& frame) {
    if (!before_) {
        return;
    }
    const double pause_s = seconds_between(before_->stamp_ns, frame.scan.stamp_ns);
    if (pause_s > least_pause_s && pause_s > usual_scan_intervals * usual_interval_s().value_or(pause_s) &&
        !is_nearer(before_->pose, frame.odom_from_robot, pause_motion_m, pause_motion_rad)) {
        findings_.push_back("there are no scans from " + at(before_->stamp_ns) + " to " + at(frame.scan.stamp_ns) +
                            ", while the odometry moves by " +
                            fixed_text(distance_m(before_->pose, frame.odom_from_robot), 2) + " m");
    }
    if (pause_s > 0.0) {
        intervals_s_.push_back(pause_s);
        if (intervals_s_.size() > intervals_kept) {
            intervals_s_.pop_front();
        }
    }
}

std::string FrameWatch::at(std::int64_t stamp_ns) const {
    return fixed_text(seconds_between(*first_ns_, stamp_ns), 1) + " s";
}

std::optional<SensorFrame> FrameWatch::take() {
    if (ready_.empty()) {
        return std::nullopt;
    }
    SensorFrame frame = std::move(ready_.front());
    ready_.pop_front();
    return frame;
}

std::vector<std::string> FrameWatch::take_findings() { return std::exchange(findings_, {}); }

}  // namespace ddtool

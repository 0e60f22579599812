#include "logs/stream/odometry_gaps.hpp"
#include "robot/stamps.hpp"

#include <algorithm>
#include <cmath>

namespace ddtool {
namespace {

constexpr double usual_intervals = 5.0;
/// Less than this is no motion: some drivers send nothing while the robot stands.
constexpr double least_motion_m = 0.05;
constexpr double least_motion_rad = 0.05;
constexpr std::size_t most_gaps = 64;  ///< scans wait for a bounded time, so that old gaps are of no use

}  // namespace

OdometryGaps::OdometryGaps(double usual_interval_s)
    : least_s_(std::max(least_gap_s, usual_intervals * usual_interval_s)) {}

std::optional<OdometryGaps::Gap> OdometryGaps::add(const StampedPose& odom_from_robot) {
    std::optional<Gap> gap;
    if (before_) {
        const double pause_s = seconds_between(before_->stamp_ns, odom_from_robot.stamp_ns);
        const Pose2 moved = between(before_->pose, odom_from_robot.pose);
        const bool has_moved =
            std::hypot(moved.x_m, moved.y_m) > least_motion_m || std::abs(moved.theta_rad) > least_motion_rad;
        if (pause_s > least_s_ && has_moved) {
            gap = Gap{before_->stamp_ns, odom_from_robot.stamp_ns, OdometryStep::guessed};
            keep(*gap);
        }
    }
    before_ = odom_from_robot;
    return gap;
}

void OdometryGaps::add_unknown(std::int64_t from_ns, std::int64_t to_ns) {
    keep({std::min(from_ns, to_ns), std::max(from_ns, to_ns), OdometryStep::unknown});
}

void OdometryGaps::keep(const Gap& gap) {
    gaps_.push_back(gap);
    if (gaps_.size() > most_gaps) {
        gaps_.pop_front();
    }
}

OdometryStep OdometryGaps::step(std::int64_t a_ns, std::int64_t b_ns) const {
    OdometryStep worst = OdometryStep::measured;
    for (const Gap& gap : gaps_) {
        if (gap.from_ns < std::max(a_ns, b_ns) && gap.to_ns > std::min(a_ns, b_ns)) {
            worst = std::max(worst, gap.step);
        }
    }
    return worst;
}

}  // namespace ddtool

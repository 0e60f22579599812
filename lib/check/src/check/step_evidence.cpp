#include "check/step_evidence.hpp"

#include <algorithm>

#include "check/scan_pairs.hpp"
#include "check/sight.hpp"

namespace ddtool::check {
namespace {

constexpr double stands_m = 0.001;
/// From standing still no robot for rooms comes farther than this within one turn of its lidar.
constexpr double stair_m = 0.2;
/// Shorter pauses are lost scans, in which a robot may have braked and started.
constexpr double least_pause_s = 3.0;
/// A pause is so many times longer than the steps around it.
constexpr double pause_share = 8.0;
constexpr double drives_m_per_s = 0.1;
/// A robot that drove before and after a pause moved in it by more than this share of the way at that speed.
constexpr double least_moved = 0.1;
/// Speeds beside a pause that differ from the mean by less than this factor are those of a robot that neither brakes
/// nor starts.
constexpr double cruise_ratio = 2.0;
/// Scans that tell whether the robot stood contradict each other in so many more of their points when they are moved
/// apart by this much.
constexpr double told_within_m = 1.0;
constexpr double told_by = 0.1;

}  // namespace

void StepWitness::add(const SensorFrame& frame) {
    if (latest_ && frame.scan.stamp_ns > latest_->scan.stamp_ns) {
        const double duration_s = 1e-9 * static_cast<double>(frame.scan.stamp_ns - latest_->scan.stamp_ns);
        judge({.duration_s = duration_s,
               .distance_m = distance_m(latest_->odom_from_robot, frame.odom_from_robot),
               .scans = duration_s > least_pause_s ? compare_with_latest(frame) : Scans::agree});
    }
    latest_ = frame;
}

/// Recorders that leave out the scans of a robot at rest make pauses, too, but there the scans agree, and only there.
StepWitness::Scans StepWitness::compare_with_latest(const SensorFrame& frame) const {
    const Sight before(*latest_);
    const Sight after(frame);
    const Pose2 motion = between(latest_->odom_from_robot, frame.odom_from_robot);
    const Agreement here = agreement(before, after, motion);
    if (here.same == 0 || here.contradicted() > PairEvidence::bad_pair) {
        return Scans::differ;
    }
    const Agreement apart = agreement(before, after, Pose2{told_within_m, 0.0, 0.0} * motion);
    const bool tell = apart.same == 0 || apart.contradicted() > here.contradicted() + told_by;
    return tell ? Scans::agree : Scans::tell_nothing;
}

/// Whether the robot was neither braking nor starting in a step.
bool StepWitness::at_usual_speed(const Step& step) const {
    const double usual = evidence_.usual_m_per_s;
    return step.speed_m_per_s() > usual / cruise_ratio && step.speed_m_per_s() < usual * cruise_ratio;
}

void StepWitness::judge(const Step& step) {
    if (step.distance_m > stands_m) {
        ++evidence_.moving;
        driven_m_ += step.distance_m;
        driven_s_ += step.duration_s;
        evidence_.usual_m_per_s = driven_m_ / driven_s_;
    }
    if (last_ && last_->distance_m <= stands_m && step.distance_m > stair_m &&
        step.duration_s < 1.5 * last_->duration_s) {
        ++evidence_.stairs;
    }
    if (last_ && before_last_) {
        const double least_speed = std::min(before_last_->speed_m_per_s(), step.speed_m_per_s());
        const bool pause = last_->duration_s > least_pause_s &&
                           last_->duration_s > pause_share * std::max(before_last_->duration_s, step.duration_s);
        const bool went_on = last_->scans == Scans::differ || (last_->scans == Scans::tell_nothing &&
                                                               at_usual_speed(*before_last_) && at_usual_speed(step));
        if (pause && went_on && least_speed > drives_m_per_s &&
            last_->distance_m < least_moved * least_speed * last_->duration_s) {
            ++evidence_.lost;
            evidence_.longest_lost_s = std::max(evidence_.longest_lost_s, last_->duration_s);
        }
    }
    before_last_ = last_;
    last_ = step;
}

}  // namespace ddtool::check

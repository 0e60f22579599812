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

}  // namespace

void StepWitness::add(const SensorFrame& frame) {
    if (latest_ && frame.scan.stamp_ns > latest_->scan.stamp_ns) {
        const double duration_s = 1e-9 * static_cast<double>(frame.scan.stamp_ns - latest_->scan.stamp_ns);
        judge({.duration_s = duration_s,
               .distance_m = distance_m(latest_->odom_from_robot, frame.odom_from_robot),
               .scans_differ = duration_s > least_pause_s && differs_from_latest(frame)});
    }
    latest_ = frame;
}

/// Whether the scan cannot be from where the odometry puts it relative to the latest one. Recorders that leave out the
/// scans of a robot at rest make pauses, too, but there the scans agree.
bool StepWitness::differs_from_latest(const SensorFrame& frame) const {
    const Agreement found =
        agreement(Sight(*latest_), Sight(frame), between(latest_->odom_from_robot, frame.odom_from_robot));
    return found.same == 0 || found.contradicted() > PairEvidence::bad_pair;
}

void StepWitness::judge(const Step& step) {
    evidence_.moving += step.distance_m > stands_m ? 1 : 0;
    if (last_ && last_->distance_m <= stands_m && step.distance_m > stair_m &&
        step.duration_s < 1.5 * last_->duration_s) {
        ++evidence_.stairs;
    }
    if (last_ && before_last_) {
        const double least_speed = std::min(before_last_->speed_m_per_s(), step.speed_m_per_s());
        const bool pause = last_->duration_s > least_pause_s &&
                           last_->duration_s > pause_share * std::max(before_last_->duration_s, step.duration_s);
        if (pause && last_->scans_differ && least_speed > drives_m_per_s &&
            last_->distance_m < least_moved * least_speed * last_->duration_s) {
            ++evidence_.lost;
            evidence_.longest_lost_s = std::max(evidence_.longest_lost_s, last_->duration_s);
        }
    }
    before_last_ = last_;
    last_ = step;
}

}  // namespace ddtool::check

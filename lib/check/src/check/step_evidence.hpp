#pragma once

#include <cstdint>
#include <optional>

#include "ddtool/robot/sensor_stream.hpp"

namespace ddtool::check {

/// Steps of the odometry from one scan to the next that no robot makes.
struct StepEvidence {
    std::uint64_t moving = 0;  ///< steps with any motion
    /// Steps in which the robot stood still and then was far away one scan later: an odometry that is held, or that is
    /// stamped in whole seconds.
    std::uint64_t stairs = 0;
    /// Pauses of the scans in which the robot was at speed before and after, and by the odometry did not move in
    /// between, although the scans before and after contradict that, or, as in a corridor, cannot tell.
    std::uint64_t lost = 0;
    double longest_lost_s = 0.0;
    double usual_m_per_s = 0.0;  ///< mean speed of the odometry where it moves
};

/// Gathers StepEvidence while a run goes on.
class StepWitness {
public:
    void add(const SensorFrame& frame);
    [[nodiscard]] const StepEvidence& evidence() const { return evidence_; }

private:
    /// What the scans before and after a step say of the odometry's motion in it.
    enum class Scans { agree, differ, tell_nothing };
    struct Step {
        double duration_s = 0.0;
        double distance_m = 0.0;
        Scans scans = Scans::agree;  ///< found for long steps alone
        [[nodiscard]] double speed_m_per_s() const { return distance_m / duration_s; }
    };
    void judge(const Step& step);
    [[nodiscard]] Scans compare_with_latest(const SensorFrame& frame) const;
    [[nodiscard]] bool at_usual_speed(const Step& step) const;

    StepEvidence evidence_;
    double driven_m_ = 0.0;
    double driven_s_ = 0.0;
    std::optional<SensorFrame> latest_;
    std::optional<Step> last_, before_last_;
};

}  // namespace ddtool::check

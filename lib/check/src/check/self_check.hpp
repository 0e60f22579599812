#pragma once

#include <optional>

#include "check/evidence.hpp"
#include "check/kept_scans.hpp"
#include "ddtool/robot/trajectory.hpp"

namespace ddtool::check {

/// Gathers, while a run goes on, what is needed to compare its result with its own scans and odometry at the end.
/// Memory is bounded, and the comparison costs as much as a few dozen updates of the filter.
class SelfCheck {
public:
    /// Call this after the filter has processed the frame. `update` is empty where the frame caused no update.
    void add(const SensorFrame& frame, const std::optional<Update>& update);

    /// \param path the run's result, with a pose for every frame that was added
    [[nodiscard]] Evidence evidence(const Trajectory& path) const;

private:
    KeptScans kept_;
    MotionWitness motion_;
    StepWitness steps_;
    std::size_t all_scans_ = 0;
    std::size_t blind_scans_ = 0;
};

}  // namespace ddtool::check

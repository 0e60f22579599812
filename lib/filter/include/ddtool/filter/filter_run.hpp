#pragma once

#include <functional>

#include "ddtool/filter/occupancy_grid.hpp"
#include "ddtool/filter/rbpf.hpp"
#include "ddtool/robot/trajectory.hpp"

namespace ddtool {

/// What a filter made of a stream.
struct FilterRun {
    Trajectory trajectory;                   ///< a pose for every scan, by the history of the best particle at the end
    Trajectory ground_truth;                 ///< where the stream has it
    OccupancyGrid map{OccupancySettings{}};  ///< the best particle's
    std::uint64_t updates = 0;
    std::uint64_t resamplings = 0;
    double read_s = 0.0;  ///< wall time in the stream
    StageTimes times;
};

/// Sees every frame after the filter has taken it, and whether it moved the filter; false ends the run.
using FrameObserver = std::function<bool(const SensorFrame& frame, bool moved)>;

/// Feeds the filter from a stream to its end; everything is empty when there was no scan.
FilterRun run_filter(SensorStream& stream, Rbpf& filter, const FrameObserver& observe);

}  // namespace ddtool

#pragma once

#include <functional>
#include <string>

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
    std::string ended_early;  ///< why the maps could not grow on and the run ended there; empty at the stream's end
};

/// Sees every frame after the filter has taken it, and whether it moved the filter; false ends the run.
using FrameObserver = std::function<bool(const SensorFrame& frame, bool moved)>;

/// Feeds the filter from a stream to its end, or to where its maps cannot grow on (MapTooLarge); everything is empty
/// when there was no scan. Throws MapTooLarge where the first scan is too much.
FilterRun run_filter(SensorStream& stream, Rbpf& filter, const FrameObserver& observe);

}  // namespace ddtool

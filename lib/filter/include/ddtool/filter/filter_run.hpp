#pragma once

#include <functional>
#include <optional>
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
    double read_s = 0.0;      ///< wall time in the stream
    StageTimes times;         ///< in the filter, over all updates
    std::string ended_early;  ///< why the maps could not grow on and the run ended there; empty at the stream's end
};

/// Sees every frame after the filter has taken it, with the update where there was one; false ends the run.
using FrameObserver = std::function<bool(const SensorFrame& frame, const std::optional<Update>& update)>;

/// Feeds the filter from a stream to its end, or to where its maps cannot grow on (MapTooLarge); everything is empty
/// when there was no scan. Throws MapTooLarge where the first scan is too much.
FilterRun run_filter(SensorStream& stream, Rbpf& filter, const FrameObserver& observe);

}  // namespace ddtool

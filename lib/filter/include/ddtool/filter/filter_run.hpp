#pragma once

#include <functional>
#include <optional>
#include <string>

#include "ddtool/filter/particle_filter.hpp"
#include "ddtool/robot/trajectory.hpp"

namespace ddtool {

/// The result of running a filter over a stream.
struct FilterRun {
    Trajectory trajectory;    ///< a pose for every scan, from the past of the particle that is best at the end
    Trajectory ground_truth;  ///< world_from_robot of every frame for which the stream has it
    OccupancyGrid map{OccupancySettings{}};  ///< map of the best particle
    std::optional<OdometryState> odometry;   ///< what was learnt of it; empty if the method learns nothing of it
    std::uint64_t updates = 0;
    std::uint64_t resamplings = 0;
    double read_s = 0.0;      ///< wall time spent reading the stream
    StageTimes times;         ///< wall time spent in the filter, summed over all updates
    std::string ended_early;  ///< why the maps could not grow further; empty if the run did not end for that reason
};

/// Called for every frame after the filter has processed it, with the update if there was one. Returning false ends the
/// run.
using FrameObserver = std::function<bool(const SensorFrame& frame, const std::optional<Update>& update)>;

/// Feeds the stream to the filter until the stream ends, `observe` returns false, or the maps cannot grow further
/// (MapTooLarge; FilterRun::ended_early then gives the reason). If there was no scan, the result is empty. Throws
/// MapTooLarge if even the first scan does not fit into the maps.
FilterRun run_filter(SensorStream& stream, ParticleFilter& filter, const FrameObserver& observe);

}  // namespace ddtool

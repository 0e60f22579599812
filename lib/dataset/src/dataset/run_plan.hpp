#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "dataset/build_settings.hpp"
#include "dataset/manifest.hpp"
#include "ddtool/methods/method.hpp"
#include "jobs/store.hpp"
#include "sim/simulation.hpp"

namespace ddtool::dataset {

/// A drive in the simulator that a filter processes.
struct WorldRun {
    std::string world;
    sim::SimulationSettings simulation;
    std::uint64_t most_particle_updates = 0;
    FilterSettings filter;
    /// Depends only on the world and the simulation, so that filters with other settings get the same piece of the
    /// drive.
    std::uint64_t drive_key = 0;
};

/// A log that a filter processes.
struct LogRun {
    std::string path;
    double range_sd_m = 0.0;  ///< of the lidar's ranges
    FilterSettings filter;
};

/// Snapshots that were recorded earlier.
struct RecordedRun {
    std::string path;
};

/// A run before it is made.
struct PlannedRun {
    RunEntry entry;  ///< the counts are not filled in yet
    std::variant<WorldRun, LogRun, RecordedRun> source;
    ThinningSettings thinning;
    jobs::Key key;  ///< of everything that decides the samples, except the name of the input
};

struct RunPlan {
    std::vector<SourceEntry> sources;
    std::vector<PlannedRun> runs;
};

/// The runs that the lists `worlds`, `logs` and `snapshots` ask for, in this order and without repetitions. The values
/// that a run draws from the mix depend on the data set's seed, the name of the source and the run's own seed, but not
/// on the other sources. Throws UsageError naming the item and the key.
RunPlan plan_runs(const Json& settings);

/// The run in words, such as "s2-textured / seed 3 / 60 particles".
std::string title_of(const RunPlan& plan, const PlannedRun& run);

}  // namespace ddtool::dataset

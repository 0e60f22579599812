#pragma once

#include <string>
#include <vector>

#include "dataset/manifest.hpp"
#include "ddtool/system/settings.hpp"

namespace ddtool::dataset {

/// A run before it is made.
struct PlannedRun {
    RunEntry entry;      ///< without counts
    std::string input;   ///< the world's name, or the path of the log or of the snapshots
    Json configuration;  ///< everything that decides the samples, but for the input's name
};

struct RunPlan {
    std::vector<SourceEntry> sources;
    std::vector<PlannedRun> runs;
};

/// The runs that the lists `worlds`, `logs` and `snapshots` ask for, in that order; equal ones once. What a run draws
/// from the mix depends on the data set's seed, the source's name and the run's own seed, not on the other sources.
/// Throws UsageError naming the item and the key.
RunPlan plan_runs(const Json& settings);

/// "s2-textured / seed 3 / 60 particles".
std::string title_of(const RunPlan& plan, const PlannedRun& run);

}  // namespace ddtool::dataset

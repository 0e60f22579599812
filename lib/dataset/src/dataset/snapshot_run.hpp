#pragma once

#include <functional>
#include <vector>

#include "dataset/run_plan.hpp"
#include "dataset/snapshot_thinning.hpp"

namespace ddtool::dataset {

/// The result of a run: samples without labels, parts and positions in a shard, and the numbers of scans and snapshots.
struct SnapshotRun {
    std::vector<Sample> samples;
    std::uint64_t scans = 0;
    std::uint64_t snapshots = 0;
    std::uint64_t log_problems = 0;
};

/// Makes a run on one thread: simulates and filters a world, filters a log, or reads recorded snapshots. on_progress
/// receives the share that is done, in 0..1. Throws Error if the run cannot be made.
SnapshotRun make_run(const PlannedRun& run, const std::function<void(double)>& on_progress);

}  // namespace ddtool::dataset

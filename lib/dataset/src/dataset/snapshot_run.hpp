#pragma once

#include <functional>
#include <vector>

#include "dataset/run_plan.hpp"
#include "dataset/snapshot_thinning.hpp"

namespace ddtool::dataset {

/// What a run gave: samples without labels, parts and places, and how many there were of what.
struct SnapshotRun {
    std::vector<Sample> samples;
    std::uint64_t scans = 0;
    std::uint64_t snapshots = 0;
    std::uint64_t log_problems = 0;
};

/// Makes a run, on one thread: simulates and filters a world, filters a log, or reads recorded snapshots. on_progress
/// gets the share done, 0..1. Throws Error for what keeps the run from being made.
SnapshotRun make_run(const PlannedRun& run, const std::function<void(double)>& on_progress);

}  // namespace ddtool::dataset

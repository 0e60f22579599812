#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "dataset/run_plan.hpp"
#include "dataset/shard.hpp"
#include "dataset/snapshot_run.hpp"
#include "jobs/runner.hpp"

namespace ddtool::dataset {

/// A finished run on disk.
struct StoredPart {
    std::filesystem::path folder;
    std::string program;  ///< the build of ddtool that made it
    std::uint64_t scans = 0;
    std::uint64_t snapshots = 0;
    std::uint64_t log_problems = 0;
    ShardEntry shard;
};

/// The result of a planned run: a stored part or a failure.
using RunResult = jobs::Result<StoredPart>;

/// The finished runs in the folder parts/ of a data set, by their ids: ID.samples.npy, ID.particles.npy, and ID.json,
/// which is written last. See jobs::Store. Safe to use from many threads.
class PartStore {
public:
    /// New parts are written to `folder`; existing ones are searched there and in `others`. Creates the folder. Throws
    /// Error.
    PartStore(const std::filesystem::path& folder, const std::vector<std::string>& others);

    /// Returns nullopt for a run that has not been made and, after a warning, for one with a damaged file. Reads every
    /// byte of the files to check them.
    [[nodiscard]] std::optional<StoredPart> find(const PlannedRun& run) const;
    StoredPart save(const PlannedRun& run, const SnapshotRun& made, const std::string& program);

private:
    std::vector<jobs::Store> stores_;  ///< the first is written to
};

/// Share `index` of `count` shares, for several machines that divide the work. It consists of every count-th run.
struct WorkShare {
    std::size_t index = 1;
    std::size_t count = 1;

    [[nodiscard]] bool has(std::size_t run) const { return run % count == index - 1; }
};
/// From "3/8", the third of eight. Throws UsageError.
WorkShare parse_work_share(const std::string& text);

/// Gives every run of the share a result: the stored one if there is one, or else one from making the run, as
/// jobs::run() does. `program` names the build that computes. Runs outside of the share get neither a value nor a
/// failure.
std::vector<RunResult> make_parts(const RunPlan& plan, const WorkShare& share, PartStore& store, ThreadPool& threads,
                                  const std::string& program);

/// Returns all runs from the store. Throws Error naming the number of missing runs and the first of them.
std::vector<RunResult> find_parts(const RunPlan& plan, const PartStore& store);

}  // namespace ddtool::dataset

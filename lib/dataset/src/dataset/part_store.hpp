#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "dataset/run_plan.hpp"
#include "dataset/shard.hpp"
#include "dataset/snapshot_run.hpp"

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

/// Finished runs, by their ids, under parts/ of a data set's folder: ID.samples.npy, ID.particles.npy, and ID.json
/// last, each whole or not at all, so that a killed build leaves only finished parts. Safe to use from many threads.
class PartStore {
public:
    /// New parts go into `folder`; they are looked for there and in `others`. Makes the folder; throws Error.
    PartStore(const std::filesystem::path& folder, const std::vector<std::string>& others);

    /// None for a run that has not been made. Throws Error naming a file that is damaged or of another run.
    [[nodiscard]] std::optional<StoredPart> find(const PlannedRun& run) const;
    StoredPart save(const PlannedRun& run, const SnapshotRun& made, const std::string& program);

private:
    std::vector<std::filesystem::path> folders_;
};

}  // namespace ddtool::dataset

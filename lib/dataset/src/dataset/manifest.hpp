#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "dataset/counts.hpp"
#include "dataset/shard.hpp"
#include "ddtool/system/settings.hpp"

namespace ddtool::dataset {

inline constexpr const char* manifest_name = "manifest.json";

/// Where snapshots come from, in the order of the names.
enum class SourceKind : std::size_t { log, snapshots, world };
inline constexpr std::array<const char*, 3> source_kind_names{"log", "snapshots", "world"};
inline std::string name_of(SourceKind kind) { return source_kind_names[index_of(kind)]; }

/// A world, a log or a file of snapshots.
struct SourceEntry {
    SourceKind kind = SourceKind::world;
    std::string name;
};

/// One pass of the filter over a source, or the reading of recorded snapshots. 0 and empty where it cannot be known.
struct RunEntry {
    std::string id;  ///< fingerprint of everything that decides its samples
    std::uint32_t source = 0;
    std::string scene;  ///< where the robot was: held_out never parts samples of one scene
    std::uint64_t seed = 0;
    std::uint64_t particles = 0;
    std::string lidar;
    std::string odometry;
    std::string method;  ///< of the filter
    double update_distance_m = 0.0;
    double update_turn_rad = 0.0;
    std::uint64_t scans = 0;         ///< that the filter took
    std::uint64_t snapshots = 0;     ///< that it made of them
    std::uint64_t candidates = 0;    ///< of these that thinning left
    std::uint64_t log_problems = 0;  ///< things in the log that were skipped
    std::string failure;             ///< why there are no samples of it; empty: there are
};

/// manifest.json: what a data set is made of. docs/formats/dataset.md has the keys.
struct Manifest {
    std::string program;  ///< the build of ddtool that put it together
    Json settings;        ///< every setting in effect
    Counts counts;        ///< samples by label rule, class, split and part
    std::vector<SourceEntry> sources;
    std::vector<RunEntry> runs;
    std::vector<ShardEntry> shards;
};

/// Throws Error naming the file for one that is missing, damaged or of a later version.
Manifest read_manifest(const std::filesystem::path& folder);
void write_manifest(const std::filesystem::path& folder, const Manifest& manifest);

}  // namespace ddtool::dataset

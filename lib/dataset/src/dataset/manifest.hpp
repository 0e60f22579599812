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

/// The kinds of sources of snapshots, in the order of their names.
enum class SourceKind : std::size_t { log, snapshots, world };
inline constexpr std::array<const char*, 3> source_kind_names{"log", "snapshots", "world"};
inline std::string name_of(SourceKind kind) { return source_kind_names[index_of(kind)]; }

/// A world, a log or a file of snapshots.
struct SourceEntry {
    SourceKind kind = SourceKind::world;
    std::string name;
};

/// One run of the filter over a source, or the reading of recorded snapshots. Values that are not known are 0 or empty.
struct RunEntry {
    std::string id;  ///< fingerprint of everything that decides its samples
    std::uint32_t source = 0;
    std::string scene;  ///< the place; the split held_out puts all samples of a scene into the same part
    std::uint64_t seed = 0;
    std::uint64_t particles = 0;
    std::string lidar;
    std::string odometry;
    std::string method;  ///< of the filter
    double update_distance_m = 0.0;
    double update_turn_rad = 0.0;
    std::uint64_t scans = 0;         ///< number of scans that the filter processed
    std::uint64_t snapshots = 0;     ///< number of snapshots that it made of them
    std::uint64_t candidates = 0;    ///< number of snapshots that are left after thinning
    std::uint64_t log_problems = 0;  ///< number of problems in the log whose places were skipped
    std::string failure;             ///< why the run has no samples; empty if it has some
};

/// The content of manifest.json, which describes a data set. The keys are in docs/formats/dataset.md.
struct Manifest {
    std::string program;  ///< the build of ddtool that assembled it
    Json settings;        ///< every setting in effect
    Counts counts;        ///< samples by label rule, class, split and part
    std::vector<SourceEntry> sources;
    std::vector<RunEntry> runs;
    std::vector<ShardEntry> shards;
};

/// Throws Error naming the file if it is missing, damaged or of a later version.
Manifest read_manifest(const std::filesystem::path& folder);
void write_manifest(const std::filesystem::path& folder, const Manifest& manifest);

}  // namespace ddtool::dataset

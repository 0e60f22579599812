#pragma once

#include <filesystem>
#include <vector>

#include "dataset/manifest.hpp"
#include "swarms.hpp"

namespace ddtool::test {

/// Swarms of 30 particles that are easy to classify: a degenerate swarm is as wide along x as odometry predicts, and
/// any other swarm has a tenth of this width.
inline std::vector<SnapshotParticle> clear_swarm(bool degenerate, std::uint64_t seed) {
    return normal_swarm(30, seed, {.sd_x_m = degenerate ? 0.1 : 0.01, .sd_y_m = 0.01}, 0.1);
}

/// Writes a data set of such swarms, of which half are degenerate. Both labels are the same, and so are all splits: of
/// ten samples, six are for training, two for validation and two for the test.
inline void write_swarm_dataset(const std::filesystem::path& folder, std::size_t count) {
    using namespace dataset;
    std::filesystem::create_directories(folder);
    std::vector<SampleRecord> records(count);
    std::vector<std::vector<SnapshotParticle>> swarms;
    for (std::size_t index = 0; index < count; ++index) {
        const bool degenerate = index % 2 == 1;
        swarms.push_back(clear_swarm(degenerate, index));
        const Label label = degenerate ? Label::degenerate : Label::not_degenerate;
        const std::size_t tenth = index / 2 % 5;
        const Part part = tenth < 3 ? Part::train : tenth == 3 ? Part::validation : Part::test;
        records[index].label = {label, label};
        records[index].part = {{{part, part}, {part, part}}};
        records[index].particle_count = static_cast<std::uint32_t>(swarms.back().size());
    }
    Manifest manifest;
    manifest.program = "test";
    manifest.settings = Json::object();
    manifest.sources = {{SourceKind::world, "drawn"}};
    manifest.runs.resize(1);
    manifest.shards = {write_shard(folder, "shard-0000", records, [&](std::size_t index) {
        return std::span<const SnapshotParticle>(swarms[index]);
    })};
    write_manifest(folder, manifest);
}

}  // namespace ddtool::test

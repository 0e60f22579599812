#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <vector>

#include "dataset/dataset.hpp"
#include "drawn_swarm.hpp"
#include "temporary_folder.hpp"

namespace ddtool::train::test {

struct SwarmDatasetOptions {
    std::size_t unlabelled = SIZE_MAX;  ///< the number of the sample that has no label
    bool alike = false;                 ///< whether all swarms are the same
};

/// A data set of random swarms with 20 to 50 particles. Every third one is degenerate.
class SwarmDataset {
public:
    explicit SwarmDataset(std::size_t samples, const SwarmDatasetOptions& options = {}) {
        std::vector<std::vector<SnapshotParticle>> swarms;
        std::vector<dataset::SampleRecord> records(samples);
        for (std::size_t sample = 0; sample < samples; ++sample) {
            const std::size_t seed = options.alike ? 0 : sample;
            swarms.push_back(drawn_swarm(20 + seed * 7 % 31, seed));
            records[sample].particle_count = static_cast<std::uint32_t>(swarms.back().size());
            const auto label = sample % 3 == 0 ? dataset::Label::degenerate : dataset::Label::not_degenerate;
            records[sample].label = {label, sample == options.unlabelled ? dataset::Label::unknown : label};
        }
        dataset::Manifest manifest{"test", Json::object(), {}, {{dataset::SourceKind::world, "drawn"}}, {{}}, {}};
        manifest.shards.push_back(dataset::write_shard(root_, "shard-0000", records, [&](std::size_t sample) {
            return std::span<const SnapshotParticle>(swarms[sample]);
        }));
        dataset::write_manifest(root_, manifest);
        data_.emplace(root_);
    }

    [[nodiscard]] const dataset::Dataset& data() const { return *data_; }

private:
    ddtool::test::TemporaryFolder folder_;
    std::filesystem::path root_ = folder_ / ".";
    std::optional<dataset::Dataset> data_;
};

}  // namespace ddtool::train::test

#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "dataset/build_settings.hpp"
#include "dataset/dataset.hpp"
#include "swarms.hpp"
#include "temporary_folder.hpp"

namespace ddtool::test {

/// A data set in which the step swarm of a degenerate sample is wide and that of any other sample narrow. Some samples
/// come from a simulated world and have the label `fisher`, every other one degenerate; the others come from a log and
/// lack this label. weak_sd_m grows with the width of the swarm. The samples belong to the parts train, train,
/// validation, test in turn, and in turn to two runs of 15 and 40 particles.
class KnownDataset {
public:
    static constexpr std::size_t of_world = 80;
    static constexpr std::size_t of_log = 10;

    /// turned_part: in this part the labels are the wrong way round.
    explicit KnownDataset(dataset::Part turned_part = dataset::Part::unused) {
        std::vector<std::vector<SnapshotParticle>> swarms;
        std::vector<dataset::SampleRecord> records(of_world + of_log);
        for (std::size_t sample = 0; sample < records.size(); ++sample) {
            records[sample] = record_of(sample, turned_part);
            swarms.push_back(swarm_of(records[sample]));
        }
        dataset::Manifest manifest{"test",
                                   dataset::default_build_json(),
                                   {},
                                   {{dataset::SourceKind::world, "w"}, {dataset::SourceKind::log, "l"}},
                                   {run("random:office:1"), run("random:office:2"), run("l")},
                                   {}};
        manifest.shards.push_back(dataset::write_shard(root_, "shard-0000", records, [&](std::size_t sample) {
            return std::span<const SnapshotParticle>(swarms[sample]);
        }));
        dataset::write_manifest(root_, manifest);
        data_.emplace(root_);
    }

    [[nodiscard]] const dataset::Dataset& data() const { return *data_; }
    [[nodiscard]] const std::filesystem::path& folder() const { return root_; }

private:
    static dataset::RunEntry run(const std::string& scene) {
        dataset::RunEntry entry;
        entry.scene = scene;
        return entry;
    }

    static dataset::SampleRecord record_of(std::size_t sample, dataset::Part turned_part) {
        using dataset::Label;
        using dataset::Part;
        constexpr std::array<Part, 4> parts{Part::train, Part::train, Part::validation, Part::test};
        dataset::SampleRecord record;
        const bool simulated = sample < of_world;
        const Part part = parts[sample / 2 % parts.size()];
        record.update = sample;
        record.source = simulated ? 0 : 1;
        record.run = simulated ? static_cast<std::uint32_t>(sample / 8 % 2) : 2;
        record.particle_count = record.run == 0 ? 15 : 40;
        const bool wide = sample % 2 == 0;
        record.weak_sd_m = (wide ? 0.1 : 0.005) * (1.0 + 0.01 * static_cast<double>(sample));
        record.odometry_sd_m = 0.05;
        record.information = {1.0 / record.weak_sd_m, 0.0, 0.0, 1e6, 0.0, 1.0};
        const Label label = wide != (part == turned_part) ? Label::degenerate : Label::not_degenerate;
        if (simulated) {
            record.label = {Label::unknown, label};
            record.part[index_of(dataset::LabelRule::fisher)] = {part, part};
        }
        return record;
    }

    static std::vector<SnapshotParticle> swarm_of(const dataset::SampleRecord& record) {
        auto swarm =
            normal_swarm(record.particle_count, record.update, {record.weak_sd_m, 0.2 * record.weak_sd_m}, 0.1);
        for (SnapshotParticle& particle : swarm) {
            particle.weight = 1.0 / static_cast<double>(swarm.size());
        }
        return swarm;
    }

    TemporaryFolder folder_;
    std::filesystem::path root_ = folder_ / ".";
    std::optional<dataset::Dataset> data_;
};

}  // namespace ddtool::test

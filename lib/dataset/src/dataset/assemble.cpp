#include "dataset/assemble.hpp"

#include <cstdio>

#include "base/overloaded.hpp"
#include "dataset/build_settings.hpp"
#include "dataset/counts.hpp"
#include "dataset/image_files.hpp"
#include "dataset/scene_split.hpp"
#include "dataset/selection.hpp"
#include "system/fingerprint.hpp"

namespace ddtool::dataset {
namespace {

/// Gives access to the particles of the candidates. One part is open at a time, so callers should go through the
/// samples run by run.
class PartParticles {
public:
    explicit PartParticles(const std::vector<RunResult>& results) : results_(results) {}

    [[nodiscard]] const MappedShard& shard(std::uint32_t run) {
        if (!shard_ || run != run_) {
            const StoredPart& part = *results_[run].value;
            // the sizes are enough here: the content was checked when the part was found, or has just been written
            shard_.emplace(part.folder, part.shard, Check::sizes);
            run_ = run;
        }
        return *shard_;
    }

private:
    const std::vector<RunResult>& results_;
    std::optional<MappedShard> shard_;
    std::uint32_t run_ = 0;
};

/// The settings of the filter that made the snapshots. For recorded snapshots they are not known, so the defaults are
/// taken.
RbpfSettings filter_of(const PlannedRun& run) {
    return std::visit(overloaded{[](const RecordedRun&) { return RbpfSettings{}; },
                                 [](const auto& source) { return source.filter.rbpf; }},
                      run.source);
}

/// The samples of all parts with their labels, run by run. first_particle still counts within the part.
std::vector<SampleRecord> labelled_candidates(const RunPlan& plan, const std::vector<RunResult>& results,
                                              const LabelSettings& rules) {
    std::vector<SampleRecord> records;
    PartParticles particles(results);
    for (std::uint32_t run = 0; run < results.size(); ++run) {
        if (!results[run].value) {
            continue;
        }
        const RbpfSettings filter = filter_of(plan.runs[run]);
        const MappedShard& shard = particles.shard(run);
        for (SampleRecord record : shard.samples()) {
            record.source = plan.runs[run].entry.source;
            record.run = run;
            set_labels(record, shard.particles(record), filter, rules);
            if (!std::holds_alternative<WorldRun>(plan.runs[run].source)) {
                // this information may enter rank correlations, but it is not exact enough for the rule
                record.label[index_of(LabelRule::fisher)] = Label::unknown;
            }
            records.push_back(record);
        }
    }
    return records;
}

std::vector<RunEntry> run_entries(const RunPlan& plan, const std::vector<RunResult>& results) {
    std::vector<RunEntry> entries;
    for (std::size_t run = 0; run < results.size(); ++run) {
        entries.push_back(plan.runs[run].entry);
        entries.back().failure = results[run].failure;
        if (const auto& part = results[run].value) {
            entries.back().scans = part->scans;
            entries.back().snapshots = part->snapshots;
            entries.back().candidates = part->shard.samples.rows;
            entries.back().log_problems = part->log_problems;
        }
    }
    return entries;
}

SampleChance chance_of(const RunPlan& plan, std::uint64_t seed) {
    std::vector<std::uint64_t> keys;
    keys.reserve(plan.runs.size());
    for (const PlannedRun& run : plan.runs) {
        keys.push_back(Fingerprint().add(run.entry.id).value());
    }
    return {seed, keys};
}

/// Removes the samples that neither rule chose.
void keep_used(std::vector<SampleRecord>& records) {
    std::erase_if(records, [](const SampleRecord& record) {
        return record.part_of(LabelRule::dispersion, Split::paper) == Part::unused &&
               record.part_of(LabelRule::fisher, Split::paper) == Part::unused;
    });
}

std::string shard_stem(std::size_t number) {
    char text[32];
    std::snprintf(text, sizeof text, "shard-%04zu", number);
    return text;
}

std::vector<ShardEntry> write_shards(const std::filesystem::path& folder, const std::vector<SampleRecord>& records,
                                     const std::vector<RunResult>& results, std::uint64_t most_bytes) {
    std::vector<ShardEntry> entries;
    PartParticles particles(results);
    for (auto begin = records.begin(); begin != records.end();) {
        auto end = begin;
        for (std::uint64_t bytes = 0; end != records.end() && bytes < most_bytes; ++end) {
            bytes += end->particle_count * sizeof(SnapshotParticle);
        }
        entries.push_back(write_shard(folder, shard_stem(entries.size()), {begin, end}, [&](std::size_t index) {
            const SampleRecord& record = begin[static_cast<std::ptrdiff_t>(index)];
            return particles.shard(record.run).particles(record);
        }));
        begin = end;
    }
    return entries;
}

/// Removes an older data set from the folder. Without its manifest it is no data set any more, and shards that are not
/// overwritten would be left behind.
void remove_older(const std::filesystem::path& folder) {
    std::filesystem::remove(folder / manifest_name);
    std::filesystem::remove_all(folder / images_name);
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        const std::string name = entry.path().filename().string();
        if (name.starts_with("shard-") && name.ends_with(".npy")) {
            std::filesystem::remove(entry.path());
        }
    }
}

}  // namespace

Manifest assemble(const std::filesystem::path& folder, const Json& settings, const RunPlan& plan,
                  const std::vector<RunResult>& results, const std::string& program) {
    const AssemblySettings assembly = assembly_from_json(settings);
    std::vector<SampleRecord> records = labelled_candidates(plan, results, assembly.labels);
    Manifest manifest{program, settings, {}, plan.sources, run_entries(plan, results), {}};
    choose_samples(records, assembly.balance, chance_of(plan, assembly.seed));
    hold_out_scenes(records, manifest.runs);
    manifest.counts = counts_of(records, assembly.balance);
    keep_used(records);
    remove_older(folder);
    manifest.shards = write_shards(folder, records, results, assembly.shard_megabytes * 1'000'000U);
    write_manifest(folder, manifest);
    return manifest;
}

}  // namespace ddtool::dataset

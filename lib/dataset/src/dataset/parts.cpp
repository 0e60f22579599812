#include "dataset/parts.hpp"

#include <charconv>

#include "ddtool/base/error.hpp"
#include "ddtool/system/json_struct.hpp"
#include "jobs/store.hpp"
#include "system/folder.hpp"

namespace ddtool::dataset {

DDTOOL_JSON_STRUCT(StoredPart, program, scans, snapshots, log_problems, shard)

namespace {

constexpr const char* parts_name = "parts";

jobs::Store store_in(const std::filesystem::path& folder) { return {folder, {.value_key = "part", .indent = 1}}; }

std::optional<std::size_t> number_in(std::string_view text) {
    std::size_t number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    return error == std::errc() && end == text.data() + text.size() ? std::optional(number) : std::nullopt;
}

/// The run as a job. All arguments must outlive the job.
jobs::Job<StoredPart> job_of(const RunPlan& plan, const PlannedRun& run, PartStore& store, const std::string& program) {
    const auto make = [&](const jobs::OnProgress& on_progress) {
        return store.save(run, make_run(run, on_progress), program);
    };
    const auto note = [](const StoredPart& part) {
        return std::to_string(part.shard.samples.rows) + " of " + std::to_string(part.snapshots) + " snapshots";
    };
    return {run.entry.id, title_of(plan, run), [&] { return store.find(run); }, make, note};
}

}  // namespace

PartStore::PartStore(const std::filesystem::path& folder, const std::vector<std::string>& others)
    : stores_{store_in(made_folder(folder / parts_name))} {
    for (const std::string& other : others) {
        const std::filesystem::path parts = std::filesystem::path(other) / parts_name;
        if (!is_folder(parts)) {
            throw Error(parts.string() + ": not there; expected the parts that build-dataset --shard made");
        }
        stores_.push_back(store_in(parts));
    }
}

std::optional<StoredPart> PartStore::find(const PlannedRun& run) const {
    for (const jobs::Store& store : stores_) {
        auto part = store.find(run.key, [&](const Json& json) {
            auto stored = json.get<StoredPart>();
            stored.folder = store.folder();
            (void)MappedShard(stored.folder, stored.shard, Check::checksums);
            return stored;
        });
        if (part) {
            return part;
        }
    }
    return std::nullopt;
}

StoredPart PartStore::save(const PlannedRun& run, const SnapshotRun& made, const std::string& program) {
    const jobs::Store& store = stores_.front();
    std::vector<SampleRecord> records;
    records.reserve(made.samples.size());
    for (const Sample& sample : made.samples) {
        records.push_back(sample.record);
    }
    StoredPart part{store.folder(), program, made.scans, made.snapshots, made.log_problems, {}};
    part.shard = write_shard(store.folder(), run.entry.id, records, [&](std::size_t index) {
        return std::span<const SnapshotParticle>(made.samples[index].particles);
    });
    store.save(run.key, part);
    return part;
}

WorkShare parse_work_share(const std::string& text) {
    const std::size_t slash = text.find('/');
    const auto index = number_in(std::string_view(text).substr(0, slash));
    const auto count = number_in(slash == std::string::npos ? "" : std::string_view(text).substr(slash + 1));
    if (!index || !count || *index < 1 || *index > *count) {
        throw UsageError("--shard " + text + ": expected i/n with i from 1 to n");
    }
    return {*index, *count};
}

std::vector<RunResult> make_parts(const RunPlan& plan, const WorkShare& share, PartStore& store, ThreadPool& threads,
                                  const std::string& program) {
    std::vector<jobs::Job<StoredPart>> all;
    std::vector<std::size_t> places;
    for (std::size_t index = 0; index < plan.runs.size(); ++index) {
        if (share.has(index)) {
            all.push_back(job_of(plan, plan.runs[index], store, program));
            places.push_back(index);
        }
    }
    const std::vector<RunResult> made = jobs::run(all, threads, {"building", "runs"}).results;
    std::vector<RunResult> results(plan.runs.size());
    for (std::size_t job = 0; job < made.size(); ++job) {
        results[places[job]] = made[job];
    }
    return results;
}

std::vector<RunResult> find_parts(const RunPlan& plan, const PartStore& store) {
    std::vector<RunResult> results;
    std::string first_missing;
    std::size_t missing = 0;
    for (const PlannedRun& run : plan.runs) {
        results.push_back({store.find(run), ""});
        if (!results.back().value && missing++ == 0) {
            first_missing = title_of(plan, run) + " (" + run.entry.id + ")";
        }
    }
    if (missing > 0) {
        throw Error(std::to_string(missing) + " of " + std::to_string(plan.runs.size()) +
                    " parts are missing, the first of " + first_missing + "; expected them from build-dataset --shard");
    }
    return results;
}

}  // namespace ddtool::dataset

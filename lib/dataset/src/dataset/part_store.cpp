#include "dataset/part_store.hpp"

#include "ddtool/base/error.hpp"
#include "ddtool/system/json_struct.hpp"
#include "system/atomic_file.hpp"
#include "system/folder.hpp"

namespace ddtool::dataset {

DDTOOL_JSON_STRUCT(StoredPart, program, scans, snapshots, log_problems, shard)

namespace {

constexpr const char* parts_name = "parts";

std::filesystem::path part_file(const std::filesystem::path& folder, const PlannedRun& run) {
    return folder / (run.entry.id + ".json");
}

StoredPart part_in(const std::filesystem::path& file, const Json& json) {
    try {
        auto part = json.at("part").get<StoredPart>();
        part.folder = file.parent_path();
        return part;
    } catch (const Json::exception& error) {
        throw Error(file.string() + ": expected what build-dataset wrote: " + error.what() + "; remove it");
    }
}

}  // namespace

PartStore::PartStore(const std::filesystem::path& folder, const std::vector<std::string>& others)
    : folders_{made_folder(folder / parts_name)} {
    for (const std::string& other : others) {
        folders_.push_back(std::filesystem::path(other) / parts_name);
        if (!std::filesystem::is_directory(folders_.back())) {
            throw Error(folders_.back().string() + ": not there; expected the parts that build-dataset --shard made");
        }
    }
}

std::optional<StoredPart> PartStore::find(const PlannedRun& run) const {
    for (const std::filesystem::path& folder : folders_) {
        const std::filesystem::path file = part_file(folder, run);
        if (!std::filesystem::exists(file)) {
            continue;
        }
        const Json json = Json::parse(read_file(file), nullptr, false);
        if (!json.is_object() || json.value("configuration", Json()) != run.configuration) {
            throw Error(file.string() + ": expected the part of the configuration that its name stands for; remove it");
        }
        return part_in(file, json);
    }
    return std::nullopt;
}

StoredPart PartStore::save(const PlannedRun& run, const SnapshotRun& made, const std::string& program) {
    const std::filesystem::path& folder = folders_.front();
    std::vector<SampleRecord> records;
    records.reserve(made.samples.size());
    for (const Sample& sample : made.samples) {
        records.push_back(sample.record);
    }
    StoredPart part{folder, program, made.scans, made.snapshots, made.log_problems, {}};
    part.shard = write_shard(folder, run.entry.id, records, [&](std::size_t index) {
        return std::span<const SnapshotParticle>(made.samples[index].particles);
    });
    write_file(part_file(folder, run), Json{{"configuration", run.configuration}, {"part", part}}.dump(1) + "\n");
    return part;
}

}  // namespace ddtool::dataset

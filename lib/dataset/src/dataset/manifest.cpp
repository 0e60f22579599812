#include "dataset/manifest.hpp"

#include "ddtool/base/error.hpp"
#include "ddtool/system/json_struct.hpp"
#include "system/atomic_file.hpp"
#include "system/expect.hpp"

namespace ddtool::dataset {

void to_json(Json& json, SourceKind kind) { json = name_of(kind); }

void from_json(const Json& json, SourceKind& kind) {
    kind = SourceKind{expect_one_of("kind", json.get<std::string>(), source_kind_names)};
}

DDTOOL_JSON_STRUCT(SourceEntry, kind, name)
DDTOOL_JSON_STRUCT(RunEntry, id, source, scene, seed, particles, lidar, odometry, method, update_distance_m,
                   update_turn_rad, scans, snapshots, candidates, log_problems, failure)
DDTOOL_JSON_STRUCT(Manifest, program, settings, counts, sources, runs, shards)

namespace {

constexpr const char* format_key = "ddtool_dataset";
constexpr int manifest_format = 2;

void expect_sound(const Manifest& manifest, const std::filesystem::path& file) {
    for (const RunEntry& run : manifest.runs) {
        if (run.source >= manifest.sources.size()) {
            throw Error(file.string() + ": damaged: the run " + run.id + " is of a source that is not there");
        }
    }
}

}  // namespace

Manifest read_manifest(const std::filesystem::path& folder) {
    const std::filesystem::path file = folder / manifest_name;
    if (!std::filesystem::exists(file)) {
        throw Error(file.string() + ": not there; expected a finished data set in " + folder.string());
    }
    const auto damaged = [&](const std::exception& error) {
        return Error(file.string() + ": damaged, or not the manifest of a data set: " + error.what());
    };
    try {
        const Json json = parse_json(read_file(file), file.string());
        if (json.at(format_key) != manifest_format) {
            throw Error(file.string() + ": version " + json.at(format_key).dump() + " of the format; expected " +
                        std::to_string(manifest_format));
        }
        auto manifest = json.get<Manifest>();
        expect_sound(manifest, file);
        return manifest;
    } catch (const Json::exception& error) {
        throw damaged(error);
    } catch (const UsageError& error) {
        throw damaged(error);
    }
}

void write_manifest(const std::filesystem::path& folder, const Manifest& manifest) {
    Json json{{format_key, manifest_format}};
    json.update(Json(manifest));
    write_file(folder / manifest_name, json.dump(1) + "\n");
}

}  // namespace ddtool::dataset

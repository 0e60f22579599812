#include "dataset/manifest.hpp"

#include "base/atomic_file.hpp"
#include "base/error.hpp"
#include "base/json_struct.hpp"

namespace ddtool::dataset {

DDTOOL_JSON_STRUCT(SourceEntry, kind, name)
DDTOOL_JSON_STRUCT(RunEntry, id, source, scene, seed, particles, lidar, odometry, method, update_distance_m,
                   update_turn_rad, scans, snapshots, candidates, log_problems, failure)
DDTOOL_JSON_STRUCT(Manifest, program, settings, counts, sources, runs, shards)

namespace {

constexpr const char* format_key = "ddtool_dataset";
constexpr int format = 2;

}  // namespace

Manifest read_manifest(const std::filesystem::path& folder) {
    const std::filesystem::path file = folder / manifest_name;
    if (!std::filesystem::exists(file)) {
        throw Error(file.string() + ": not there; expected a finished data set in " + folder.string());
    }
    const Json json = Json::parse(read_file(file), nullptr, false);
    if (!json.is_object() || !json.contains(format_key)) {
        throw Error(file.string() + ": damaged, or not the manifest of a data set");
    }
    if (json.at(format_key) != format) {
        throw Error(file.string() + ": version " + json.at(format_key).dump() + " of the format; expected " +
                    std::to_string(format));
    }
    try {
        return json.get<Manifest>();
    } catch (const Json::exception& error) {
        throw Error(file.string() + ": " + error.what());
    }
}

void write_manifest(const std::filesystem::path& folder, const Manifest& manifest) {
    Json json{{format_key, format}};
    json.update(Json(manifest));
    write_file(folder / manifest_name, json.dump(1) + "\n");
}

}  // namespace ddtool::dataset

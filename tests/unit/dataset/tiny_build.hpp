#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "dataset/assemble.hpp"
#include "dataset/build_settings.hpp"
#include "dataset/dataset.hpp"
#include "system/atomic_file.hpp"
#include "temporary_folder.hpp"
#include "tiny_world.hpp"

namespace ddtool::dataset::test {

/// The settings for rooms of 4 x 4 m and of other sizes, with a route of one metre in each, two runs per room, and a
/// filter with few particles, so that a run takes milliseconds.
inline Json tiny_settings(const ddtool::test::TemporaryFolder& folder, std::size_t rooms = 4) {
    Json settings = default_build_json();
    Json worlds = Json::array();
    for (std::size_t room = 0; room < rooms; ++room) {
        const double far_wall_m = 2.0 + static_cast<double>(room);
        const auto file = folder / ("room" + std::to_string(room) + ".json");
        worlds.push_back({{"world", ddtool::test::write_tiny_world(file, far_wall_m)}, {"seeds", {{"count", 2}}}});
    }
    merge_settings(settings,
                   {{"worlds", worlds},
                    {"mix", {{"particles", {2, 3, 5}}, {"odometry", {"good", "poor"}}}},
                    {"thinning", {{"every", 2}, {"most_per_run", 4}}},
                    {"simulation", {{"lidar", {{"beams", 90}, {"rate_hz", 5.0}}}}},
                    {"balance", {{"degenerate", 10}, {"not_degenerate", 10}}}},
                   "test");
    return settings;
}

inline constexpr const char* this_program = "this build";

inline std::vector<RunResult> make_in(const std::filesystem::path& folder, const Json& settings,
                                      const WorkShare& share = {}, std::size_t threads = 1) {
    PartStore store(folder, {});
    ThreadPool pool(threads);
    return make_parts(plan_runs(settings), share, store, pool, this_program);
}

inline Dataset build_in(const std::filesystem::path& folder, const Json& settings, std::size_t threads = 1) {
    assemble(folder, settings, plan_runs(settings), make_in(folder, settings, {}, threads), this_program);
    return Dataset(folder, Check::checksums);
}

inline Dataset merge_in(const std::filesystem::path& folder, const Json& settings,
                        const std::vector<std::string>& others) {
    const RunPlan plan = plan_runs(settings);
    assemble(folder, settings, plan, find_parts(plan, PartStore(folder, others)), this_program);
    return Dataset(folder, Check::checksums);
}

/// Every file of the data set itself, by its name.
inline std::map<std::string, std::string> files_of(const std::filesystem::path& folder) {
    std::map<std::string, std::string> files;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        if (entry.is_regular_file()) {
            files[entry.path().filename().string()] = read_file(entry.path());
        }
    }
    return files;
}

}  // namespace ddtool::dataset::test

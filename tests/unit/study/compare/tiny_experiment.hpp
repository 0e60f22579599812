#pragma once

#include <filesystem>
#include <string>

#include "study/compare/experiment.hpp"
#include "study/compare/runner.hpp"
#include "tiny_world.hpp"

namespace ddtool::compare::test {

/// The settings that compare odometry with a filter of two particles in this world, with a lidar of few beams.
inline Json tiny_settings(const std::string& world_file) {
    Json settings = default_experiment_json();
    merge_settings(settings,
                   {{"worlds", Json::array({{{"name", "tiny"}, {"world", world_file}}})},
                    {"methods", Json::array({{{"name", "odometry"}, {"kind", "odometry"}},
                                             {{"name", "filter"}, {"filter", {{"particles", 2}}}}})},
                    {"seeds", {{"count", 3}}},
                    {"simulation", {{"lidar", {{"beams", 90}, {"rate_hz", 5.0}}}}}},
                   "test");
    return settings;
}

inline RunOutcome run_in(const std::filesystem::path& folder, const Json& settings, std::size_t threads = 1) {
    const Experiment experiment = experiment_from_json(settings);
    ResultStore store(folder);
    ThreadPool pool(threads);
    return run_cells(experiment, cells_of(experiment), store, pool, "this build");
}

}  // namespace ddtool::compare::test

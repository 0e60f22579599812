#include "setting_lists.hpp"

#include "dataset/build_settings.hpp"
#include "localization/localization_settings.hpp"
#include "log_options.hpp"
#include "maps/going_on.hpp"
#include "methods/settings_json.hpp"
#include "sim/simulation_json.hpp"
#include "study/ablation/plan.hpp"
#include "study/compare/experiment.hpp"
#include "train/train_settings.hpp"

namespace ddtool {
namespace {

Setting group(const std::string& key, const std::vector<Setting>& settings) { return {key, {}, "", "", "", settings}; }

Setting back_end_setting() {
    return {"back_end",
            Allowed::one_of({"graph", "none"}),
            "",
            "Whether a pose graph closes loops and smooths the path at the end of the run.",
            "docs/graph.md",
            {}};
}

}  // namespace

Json default_slam_settings() {
    return {{"log", default_log_settings()},
            {"filter", filter_settings_json({})},
            {"back_end", "none"},
            {maps::going_on_name, maps::going_on_json({})}};
}

Json default_localize_settings() {
    Json settings{{"log", default_log_settings()}};
    settings.update(localization::default_localization_json());
    return settings;
}

bool asks_for_graph(const Json& settings) {
    expect_allowed(settings, {back_end_setting()}, "");
    return settings.at("back_end") == "graph";
}

std::vector<SettingList> setting_lists() {
    // a named object, because GCC 12 warns that a temporary might be used uninitialised
    const train::TrainSettings training;
    std::vector<Setting> localize{group("log", log_setting_list())};
    const std::vector<Setting> in_map = localization::localization_setting_list();
    localize.insert(localize.end(), in_map.begin(), in_map.end());
    return {
        {"slam",
         {group("log", log_setting_list()), group("filter", filter_setting_list()), back_end_setting(),
          group(maps::going_on_name, maps::going_on_setting_list())},
         default_slam_settings()},
        {"localize", std::move(localize), default_localize_settings()},
        {"simulate", sim::simulation_setting_list(), sim::default_simulation_json()},
        {"build-dataset", dataset::build_setting_list(), dataset::default_build_json()},
        {"train", train::train_setting_list(), training},
        {"compare", compare::experiment_setting_list(), compare::default_experiment_json()},
        {"ablation", ablation::plan_setting_list(), ablation::default_plan_json()},
    };
}

}  // namespace ddtool

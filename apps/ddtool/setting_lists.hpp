#pragma once

#include <string>
#include <vector>

#include "system/setting_rows.hpp"

namespace ddtool {

/// The settings of one command.
struct SettingList {
    std::string command;  ///< "ablation" stands for the plan that `ddtool eval --ablation` reads
    std::vector<Setting> settings;
    Json defaults;
};

/// The settings of every command that has any.
std::vector<SettingList> setting_lists();

/// The settings of slam with their defaults.
Json default_slam_settings();

/// The settings of localize with their defaults.
Json default_localize_settings();

/// Whether the settings of slam ask for the pose graph. Throws UsageError for a value that `back_end` cannot have.
bool asks_for_graph(const Json& settings);

}  // namespace ddtool

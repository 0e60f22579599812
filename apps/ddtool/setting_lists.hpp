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

/// The setting of slam that says whether there is a back end.
Setting back_end_setting();

}  // namespace ddtool

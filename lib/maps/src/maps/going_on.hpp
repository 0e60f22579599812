#pragma once

#include <cstddef>
#include <vector>

#include "ddtool/system/settings.hpp"
#include "system/setting_rows.hpp"

namespace ddtool::maps {

/// How a map of before changes when a later drive goes on with it.
struct GoingOnSettings {
    /// The evidence for a wall of before halves with so many scans that see through it; 0: each counts alike.
    int half_life_scans = 5;
    /// A scan of an earlier drive is dropped if so many later ones see what it saw; 0: none is dropped.
    std::size_t covering_scans = 10;
};

std::vector<Setting> going_on_setting_list();
Json going_on_json(const GoingOnSettings& settings);
/// Throws UsageError naming the setting.
GoingOnSettings going_on_from_json(const Json& json);

/// The half-life in the settings of the run that made a map; the default where they have none, as those of maps of
/// before and of other programs.
int half_life_of(const Json& settings_of_run);

/// The name of the group in the settings of a run.
inline constexpr const char* going_on_name = "going_on";

}  // namespace ddtool::maps

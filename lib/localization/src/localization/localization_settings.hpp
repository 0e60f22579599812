#pragma once

#include <vector>

#include "ddtool/methods/method.hpp"
#include "localization/mode_resampling.hpp"
#include "system/setting_rows.hpp"

namespace ddtool::localization {

/// What a localisation is set by. The cells are those of the map.
struct LocalizationSettings {
    FilterSettings filter;  ///< filter.rbpf.particles is the least number of particles
    ModeResamplingSettings particles;
};

/// The descriptions of the settings, in the order of their JSON.
std::vector<Setting> localization_setting_list();

/// Every setting with its default: "filter" and "localization".
Json default_localization_json();

/// Throws UsageError naming the key for a value that is not allowed.
LocalizationSettings localization_from_json(const Json& json);

}  // namespace ddtool::localization

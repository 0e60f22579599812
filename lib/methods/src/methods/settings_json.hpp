#pragma once

#include <vector>

#include "ddtool/methods/method.hpp"
#include "system/setting_rows.hpp"

namespace ddtool {

/// What is known of each setting of the filter, in the order of their JSON.
const std::vector<Setting>& filter_setting_list();

/// Every setting of the filter with its value; keys are the fields' names.
Json filter_settings_json(const FilterSettings& settings);

/// The same back. Throws UsageError naming the key for a value that makes no sense.
FilterSettings filter_settings_from_json(const Json& json);

/// The parts in effect by name, as parts_of() has them.
Json parts_json(const MethodSettings& settings);

/// The defaults for many runs at once, whose seeds come from a list.
Json common_filter_json();

}  // namespace ddtool

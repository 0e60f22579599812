#pragma once

#include <vector>

#include "ddtool/methods/method.hpp"
#include "system/setting_rows.hpp"

namespace ddtool {

/// The description of each setting of the filter, in the order of their JSON.
const std::vector<Setting>& filter_setting_list();

/// Every setting of the filter with its value; the keys are the names of the fields.
Json filter_settings_json(const FilterSettings& settings);

/// The JSON without the settings of filters and of their parts that its method does not use, so that results are
/// recognised by what decided them alone.
Json without_other_filters(Json filter);

/// Reads the settings back from such JSON. Throws UsageError naming the key for an invalid value.
FilterSettings filter_settings_from_json(const Json& json);

/// The parts that are used, by name, as parts_of() returns them.
Json parts_json(const MethodSettings& settings);

/// The default settings for many runs at once, whose seeds come from a list instead.
Json common_filter_json();

}  // namespace ddtool

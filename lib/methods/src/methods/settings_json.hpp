#pragma once

#include "ddtool/methods/method.hpp"
#include "ddtool/system/settings.hpp"

namespace ddtool {

/// Every setting of the filter with its value; keys are the fields' names.
Json filter_settings_json(const FilterSettings& settings);

/// The same back. Throws UsageError naming the key for a value that makes no sense.
FilterSettings filter_settings_from_json(const Json& json);

/// The parts in effect by name, as parts_of() has them.
Json parts_json(const MethodSettings& settings);

/// The defaults for many runs at once, whose seeds come from a list.
Json common_filter_json();

}  // namespace ddtool

#pragma once

#include "base/settings.hpp"
#include "slam/rbpf.hpp"

namespace ddtool {

/// Every setting of the filter with its value; keys are the fields' names.
Json filter_settings_json(const RbpfSettings& settings);

/// The same back. Throws UsageError naming the key for a value that makes no sense.
RbpfSettings filter_settings_from_json(const Json& json);

/// The defaults for many runs at once, whose seeds come from a list.
Json common_filter_json();

}  // namespace ddtool

#pragma once

#include <vector>

#include "ddtool/logs/log_stream.hpp"
#include "system/setting_rows.hpp"

namespace ddtool {

/// The description of each setting under "log".
const std::vector<Setting>& log_setting_list();

/// The defaults of the settings under "log", which every command that reads a log has.
Json default_log_settings();

/// Reads the settings under "log". Throws UsageError naming the key.
LogOptions log_options(const Json& log_settings);

}  // namespace ddtool

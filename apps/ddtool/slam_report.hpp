#pragma once

#include <string>
#include <vector>

#include "ddtool/logs/log_stream.hpp"
#include "ddtool/system/settings.hpp"

namespace ddtool {

/// What was used of a log and what was lost, for run.json.
Json log_report(const std::string& file, const LogSummary& log);

/// ddtool's version and those of its libraries, for run.json.
Json version_report();

/// What a person wants to know of a run, from its run.json.
std::string slam_summary(const Json& report, const std::string& folder, const std::vector<std::string>& files);

}  // namespace ddtool

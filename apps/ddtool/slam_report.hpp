#pragma once

#include <string>
#include <vector>

#include "ddtool/logs/log_stream.hpp"
#include "ddtool/system/settings.hpp"
#include "run/run_report.hpp"

namespace ddtool {

/// What was used of a log and what was lost, for run.json.
Json log_report(const std::string& file, const LogSummary& log);

/// ddtool's version and those of its libraries, for run.json.
Json version_report();

/// What a person wants to know of a run.
std::string slam_summary(const RunReport& run, const CostReport& cost, const std::string& folder,
                         const std::vector<std::string>& files);

}  // namespace ddtool

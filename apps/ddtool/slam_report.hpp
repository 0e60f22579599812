#pragma once

#include <string>
#include <vector>

#include "ddtool/logs/log_stream.hpp"
#include "ddtool/system/settings.hpp"
#include "run/run_summary.hpp"

namespace ddtool {

/// What was used of a log and what was lost, for run.json.
Json log_report(const std::string& file, const LogSummary& log);

/// The versions of ddtool and its libraries, for run.json.
Json version_report();

/// The summary of a run that is printed for the user. `self_check`: the verdict of the self-check, in a word.
std::string slam_summary(const RunSummary& run, const RunCost& cost, const std::string& self_check,
                         const std::string& folder, const std::vector<std::string>& files);

}  // namespace ddtool

#pragma once

#include <chrono>
#include <string>
#include <vector>

#include "ddtool/logs/log_stream.hpp"
#include "ddtool/system/settings.hpp"
#include "run/localization_course.hpp"
#include "run/run_summary.hpp"

namespace ddtool {

/// What was used of a log and what was lost, for run.json.
Json log_report(const std::string& file, const LogSummary& log);

/// The versions of ddtool and its libraries, for run.json.
Json version_report();

/// The summary of a run that is printed for the user. `self_check`: the verdict of the self-check, in a word.
std::string slam_summary(const RunSummary& run, const RunCost& cost, const std::string& self_check,
                         const std::string& folder, const std::vector<std::string>& files);

/// The summary of a localisation that is printed for the user.
std::string localize_summary(const RunSummary& run, const RunCost& cost, const LocalizationCourse& course,
                             const std::string& folder, const std::vector<std::string>& files);

/// The reasons, other than damage, why less of the log was used than it holds or a run needs, one line each.
std::vector<std::string> shortfalls(const std::string& file, const LogSummary& log, bool interrupted,
                                    const FilterRun& run);

/// What the process has taken so far.
RunCost run_cost(std::size_t threads, std::chrono::steady_clock::time_point start);

}  // namespace ddtool

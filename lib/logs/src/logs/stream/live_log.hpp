#pragma once

#include <filesystem>
#include <functional>
#include <memory>

#include "ddtool/logs/log_stream.hpp"

namespace ddtool {

/// MCAP that comes in while it is read: from standard input (a pipe), or in a file that a recorder is still writing,
/// which ends with its footer. Both end when `stop` says yes, too. Read once: what the survey needs (log_survey.hpp) is
/// waited for before the first frame. Throw Error for what is not MCAP.
std::unique_ptr<LogStream> open_standard_input(const LogOptions& options, std::function<bool()> stop,
                                               LogProblemHandler on_problem);
std::unique_ptr<LogStream> follow_log(const std::filesystem::path& path, const LogOptions& options,
                                      std::function<bool()> stop, LogProblemHandler on_problem);

}  // namespace ddtool

#pragma once

#include <filesystem>
#include <functional>
#include <memory>

#include "ddtool/logs/log_stream.hpp"

namespace ddtool {

/// MCAP that is read while it is being written: from standard input (a pipe), or from a file that a recorder is still
/// writing and that ends with the footer. Both also end when `stop` returns true. The data can be read only once, so
/// the first frame comes only after the part that the survey needs (log_survey.hpp) has arrived. Both functions throw
/// Error if the data are not MCAP.
std::unique_ptr<LogStream> open_standard_input(const LogOptions& options, std::function<bool()> stop,
                                               LogProblemHandler on_problem);
std::unique_ptr<LogStream> follow_log(const std::filesystem::path& path, const LogOptions& options,
                                      std::function<bool()> stop, LogProblemHandler on_problem);

}  // namespace ddtool

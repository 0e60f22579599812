#pragma once

#include <string>
#include <vector>

#include "command.hpp"
#include "ddtool/base/error.hpp"
#include "ddtool/logs/log_stream.hpp"
#include "logs/stream/log_settings.hpp"

namespace ddtool {

inline constexpr const char* log_file_help =
    "The log: MCAP, ROS 1 bag, rosbag2 (folder or .db3) or CARMEN; also compressed or in a tar archive";

/// Appends the options that every command that reads a log has.
void append_log_options(std::vector<Option>& options);

/// A word of a command line; quoted if a shell would take it for several words or more.
std::string shell_word(const std::string& word);

/// The options that give these settings under "log", as they are typed, each with a space in front; empty for the
/// defaults.
std::string log_options_text(const Json& log_settings);

/// The assumptions that were made about a log, and what could not be read of it, as one line each.
std::vector<std::string> log_warnings(const LogSummary& summary);

/// Tells the user what was assumed about a log and what was skipped in it. The first problems are printed as they
/// occur, the others are counted.
class LogReport {
public:
    static constexpr std::size_t max_shown = 5;

    /// A handler for open_log(). It must not outlive the report.
    LogProblemHandler handler();
    /// Prints warnings of assumptions and losses. Returns done, or done_with_loss if there were problems.
    ExitCode finish(const LogSummary& summary) const;

private:
    std::size_t problems_ = 0;
};

}  // namespace ddtool

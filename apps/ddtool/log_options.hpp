#pragma once

#include <string>
#include <vector>

#include "command.hpp"
#include "ddtool/base/error.hpp"
#include "ddtool/logs/log_stream.hpp"
#include "system/setting_rows.hpp"

namespace ddtool {

/// What is known of each of the settings under "log".
const std::vector<Setting>& log_setting_list();

/// What every command that reads a log takes: its settings are under "log".
Json default_log_settings();

inline constexpr const char* log_file_help =
    "The log: MCAP, ROS 1 bag, rosbag2 (folder or .db3) or CARMEN (also .gz, .bz2)";

/// The options of every command that reads a log.
void append_log_options(std::vector<Option>& options);

/// From the settings under "log". Throws UsageError naming the key.
LogOptions log_options(const Json& log_settings);

/// What was assumed of a log and what was lost of it, a line each.
std::vector<std::string> log_warnings(const LogSummary& summary);

/// Tells the user what was skipped in a log and what was assumed: the first problems as they come, the rest as a count.
class LogReport {
public:
    static constexpr std::size_t max_shown = 5;

    /// For open_log(); must not outlive the report.
    LogProblemHandler handler();
    /// Warns of assumptions and losses. Returns done, or done_with_loss when there were problems.
    ExitCode finish(const LogSummary& summary) const;

private:
    std::size_t problems_ = 0;
};

}  // namespace ddtool

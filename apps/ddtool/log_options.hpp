#pragma once

#include <array>
#include <string>
#include <vector>

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

/// An option and the setting it stands for, for Command::bind_option().
struct LogOption {
    const char* option;
    const char* path;
    const char* help;
};
inline constexpr std::array<LogOption, 4> log_option_table{{
    {"--scan-topic", "log.scan_topic", "Laser scans to use; found by type where not given"},
    {"--odom-topic", "log.odom_topic", "Odometry or transforms to use; found by type where not given"},
    {"--ground-truth-topic", "log.ground_truth_topic", "True poses; found by name where not given"},
    {"--laser-pose", "log.laser_pose", "The laser on the robot, x,y,yaw in metres and radians; else the log's own"},
}};

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

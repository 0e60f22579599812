#include "log_options.hpp"

#include <algorithm>
#include <string_view>

#include "system/log.hpp"

namespace ddtool {
namespace {

/// The options that stand for settings under "log".
const std::vector<Option>& log_option_list() {
    static const std::vector<Option> options{
        {"--robot", SettingPath{"log.robot"}, "Of several robots, the one with this name before its topics or frames"},
        {"--scan-topic", SettingPath{"log.scan_topic"},
         "Laser scans to use; found by type where not given; several lidars: A,B"},
        {"--cloud-topic", SettingPath{"log.cloud_topic"},
         "Point clouds to make scans of; found by type where not given and without laser scans"},
        {"--height", SettingPath{"log.height"},
         "MIN,MAX in metres above the robot's origin: points of a cloud there become its scan; else around the lidar"},
        {"--odometry", SettingPath{"log.odometry"},
         "none: leave out the log's odometry and work out the motion from the scans", "log|none"},
        {"--odom-topic", SettingPath{"log.odom_topic"}, "Odometry or transforms to use; found by type where not given"},
        {"--odom-path", SettingPath{"log.odom_path"},
         "Where several publishers are interleaved in the odometry, the number of the one to use; 0: the best", "N"},
        {"--odom-delay", SettingPath{"log.odom_delay"},
         "By how many seconds the odometry's stamps are later than the scans'; found where not given, 0: none"},
        {"--ground-truth-topic", SettingPath{"log.ground_truth_topic"}, "True poses; found by name where not given"},
        {"--imu-topic", SettingPath{"log.imu_topic"},
         "Inertial sensor to take the turns from; where not given, one that is better than the odometry; none: none"},
        {"--laser-pose", SettingPath{"log.laser_pose"},
         "The laser on the robot, x,y,yaw in metres and radians; else the log's own"},
        {"--no-return", SettingPath{"log.no_return"},
         "Readings that mean no return, in metres, separated by commas; found where not given, 0: there are none"},
        {"--range-max", SettingPath{"log.range_max"}, "Readings above it are no return, in metres; 0: the log's own"}};
    return options;
}

/// A setting as it is typed behind its option: a list without its brackets.
std::string typed(const Json& value) {
    if (value.is_string()) {
        return value.get<std::string>();
    }
    const std::string text = value.dump();
    return value.is_array() ? text.substr(1, text.size() - 2) : text;
}

}  // namespace

void append_log_options(std::vector<Option>& options) {
    options.insert(options.end(), log_option_list().begin(), log_option_list().end());
}

std::string shell_word(const std::string& word) {
    constexpr std::string_view plain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789/._-+,:=@%";
    if (!word.empty() && word.find_first_not_of(plain) == std::string::npos) {
        return word;
    }
    std::string quoted = word;
    for (std::size_t at = quoted.find('\''); at != std::string::npos; at = quoted.find('\'', at + 4)) {
        quoted.replace(at, 1, "'\\''");
    }
    return "'" + quoted + "'";
}

std::string log_options_text(const Json& log_settings) {
    const Json defaults = default_log_settings();
    std::string text;
    for (const auto& [key, value] : log_settings.items()) {
        if (value == defaults.at(key)) {
            continue;
        }
        const auto stands_for = [&](const Option& option) {
            return std::get<SettingPath>(option.value).path == "log." + key;
        };
        const auto option = std::ranges::find_if(log_option_list(), stands_for);
        text += option == log_option_list().end()
                    ? " --set " + shell_word("log." + key + "=" + typed(value))
                    : " " + option->name + (typed(value).starts_with('-') ? "=" : " ") + shell_word(typed(value));
    }
    return text;
}

LogProblemHandler LogReport::handler() {
    return [this](const LogProblem& problem) {
        if (problems_++ < max_shown) {
            log_warning(problem.what);
        }
    };
}

std::vector<std::string> log_warnings(const LogSummary& summary) {
    std::vector<std::string> lines = summary.assumptions;
    if (summary.problems > 0) {
        lines.push_back("problems in the log: " + std::to_string(summary.problems) + "; bytes known to be lost: " +
                        std::to_string(summary.bytes_lost) + "; scans read: " + std::to_string(summary.scans));
    }
    return lines;
}

ExitCode LogReport::finish(const LogSummary& summary) const {
    for (const std::string& line : log_warnings(summary)) {
        log_warning(line);
    }
    return summary.problems == 0 ? ExitCode::done : ExitCode::done_with_loss;
}

}  // namespace ddtool

#include "log_options.hpp"

#include "system/log.hpp"

namespace ddtool {
namespace {

std::optional<Pose2> laser_pose(const Json& value) {
    if (value.empty()) {
        return std::nullopt;
    }
    const bool is_pose =
        value.is_array() && value.size() == 3 && value[0].is_number() && value[1].is_number() && value[2].is_number();
    if (!is_pose) {
        throw UsageError("log.laser_pose: expected three numbers x,y,yaw");
    }
    return Pose2{value[0], value[1], value[2]};
}

}  // namespace

Json default_log_settings() {
    return {{"scan_topic", ""}, {"odom_topic", ""}, {"ground_truth_topic", ""}, {"laser_pose", Json::array()}};
}

void append_log_options(std::vector<Option>& options) {
    options.insert(
        options.end(),
        {{"--scan-topic", Setting{"log.scan_topic"}, "Laser scans to use; found by type where not given"},
         {"--odom-topic", Setting{"log.odom_topic"}, "Odometry or transforms to use; found by type where not given"},
         {"--ground-truth-topic", Setting{"log.ground_truth_topic"}, "True poses; found by name where not given"},
         {"--laser-pose", Setting{"log.laser_pose"},
          "The laser on the robot, x,y,yaw in metres and radians; else the log's own"}});
}

LogOptions log_options(const Json& log_settings) {
    return {.scan_topic = log_settings.at("scan_topic"),
            .odom_topic = log_settings.at("odom_topic"),
            .ground_truth_topic = log_settings.at("ground_truth_topic"),
            .laser_pose = laser_pose(log_settings.at("laser_pose"))};
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

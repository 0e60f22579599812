#include "logs/stream/log_settings.hpp"

#include <cmath>
#include <numbers>
#include <utility>

#include "base/text.hpp"
#include "ddtool/base/error.hpp"

namespace ddtool {
namespace {

SettingRow<LogOptions> laser_pose_row() {
    const Allowed numbers = Allowed::numbers(3, -1000.0, 1000.0);
    return {{"laser_pose",
             numbers,
             "",
             "Pose of the laser on the robot, x and y in metres and yaw in radians; empty "
             "for the log's own.",
             "",
             {}},
            [](Json& json, const LogOptions& options) {
                const auto& pose = options.laser_pose;
                json["laser_pose"] = pose ? Json{pose->x_m, pose->y_m, pose->theta_rad} : Json::array();
            },
            [](const Json& json, LogOptions& options) {
                const Json& pose = json.at("laser_pose");
                options.laser_pose = pose.empty() ? std::nullopt : std::optional(Pose2{pose[0], pose[1], pose[2]});
            }};
}

SettingRow<LogOptions> odom_delay_row() {
    return {{"odom_delay",
             Allowed::numbers(1, -1e6, 1e6),
             "s",
             "By how much the stamps of the odometry are later than those of the scans; empty for what the log shows, "
             "0 for no delay.",
             "docs/formats/logs.md",
             {}},
            [](Json& json, const LogOptions& options) {
                json["odom_delay"] = options.odom_delay_s ? Json{*options.odom_delay_s} : Json::array();
            },
            [](const Json& json, LogOptions& options) {
                const Json& delay = json.at("odom_delay");
                options.odom_delay_s = delay.empty() ? std::nullopt : std::optional<double>(delay[0]);
            }};
}

SettingRow<LogOptions> odometry_row() {
    return {{"odometry",
             Allowed::one_of({"log", "none"}),
             "",
             "none: leave out the odometry of the log and work out the motion from the scans.",
             "docs/formats/logs.md",
             {}},
            [](Json& json, const LogOptions& options) { json["odometry"] = options.with_odometry ? "log" : "none"; },
            [](const Json& json, LogOptions& options) { options.with_odometry = json.at("odometry") != "none"; }};
}

SettingRow<LogOptions> echo_row() {
    return {
        {"echo",
         Allowed::one_of({"first", "strongest"}),
         "",
         "Which echo is the range of a beam that has several (MultiEchoLaserScan).",
         "docs/formats/logs.md",
         {}},
        [](Json& json, const LogOptions& options) { json["echo"] = options.strongest_echo ? "strongest" : "first"; },
        [](const Json& json, LogOptions& options) { options.strongest_echo = json.at("echo") == "strongest"; }};
}

SettingRow<LogOptions> height_row() {
    return {{"height",
             Allowed::numbers(2, -1000.0, 1000.0),
             "m",
             "Least and largest height above the robot's origin of the points of a cloud that become its scans; empty "
             "for those around the lidar.",
             "docs/formats/logs.md",
             {}},
            [](Json& json, const LogOptions& options) {
                const auto& height = options.height;
                json["height"] = height ? Json{height->min_m, height->max_m} : Json::array();
            },
            [](const Json& json, LogOptions& options) {
                const Json& height = json.at("height");
                options.height = height.empty() ? std::nullopt : std::optional(HeightBand{height[0], height[1]});
            }};
}

const SettingTable<LogOptions>& log_rows() {
    static const SettingTable<LogOptions> rows{
        {"robot", &LogOptions::robot, Allowed::text(), "",
         "Which of several robots to use: the name before its topics or frames; empty for the one whose scans are "
         "used.",
         "docs/formats/logs.md"},
        {"scan_topic", &LogOptions::scan_topic, Allowed::text(), "",
         "Topic of the laser scans to use; found by type where it is empty. Several, separated by commas, are several "
         "lidars, of which the first is the one that gives the poses.",
         "docs/formats/logs.md"},
        {"cloud_topic", &LogOptions::cloud_topic, Allowed::text(), "",
         "Topic of the point clouds from which scans are made; found by type where it is empty and there are no laser "
         "scans.",
         "docs/formats/logs.md"},
        height_row(),
        {"cloud_beams", &LogOptions::cloud_beams, Allowed::whole(0, 100000), "",
         "Number of beams of a full turn of the scans that are made from point clouds; 0 for as many as the cloud "
         "fills.",
         "docs/formats/logs.md"},
        echo_row(),
        odometry_row(),
        {"odom_topic", &LogOptions::odom_topic, Allowed::text(), "",
         "Topic of the odometry or transforms to use; found by type where it is empty.", "docs/formats/logs.md"},
        {"odom_path", &LogOptions::odom_path, Allowed::whole(0, 16), "",
         "Where several publishers are interleaved in the odometry, the number of the one to use, in the order of "
         "their "
         "first poses; 0 for the one that fits the scans best.",
         "docs/formats/logs.md"},
        odom_delay_row(),
        {"ground_truth_topic", &LogOptions::ground_truth_topic, Allowed::text(), "",
         "Topic of the true poses; found by name where it is empty.", "docs/formats/logs.md"},
        {"imu_topic", &LogOptions::imu_topic, Allowed::text(), "",
         "Topic of the inertial sensor whose turns are used in place of the odometry's; empty: one that is found by "
         "type, if it is better; none: none.",
         "docs/formats/logs.md"},
        laser_pose_row(),
        {"no_return", &LogOptions::no_return_m, Allowed::numbers(0, 0.0, 1e6), "m",
         "The readings that mean that a beam has no return; empty to find them, 0 alone where there are none.",
         "docs/formats/logs.md"},
        {"range_max", &LogOptions::range_max_m, Allowed::number(0.0, 1e6), "m",
         "The range up to which readings are echoes, in place of the log's own; 0 for the log's own.",
         "docs/formats/logs.md"},
    };
    return rows;
}

/// Throws UsageError for a yaw of more than a full turn, which is one in degrees.
void expect_yaw_in_radians(const LogOptions& options) {
    if (options.laser_pose && std::abs(options.laser_pose->theta_rad) > 2.0 * std::numbers::pi) {
        throw UsageError("--laser-pose: expected a yaw in radians, at most a full turn (6.28), not " +
                         fixed_text(options.laser_pose->theta_rad, 2) + "; is it in degrees?");
    }
}

/// Throws UsageError if one option leaves out what another asks for.
void expect_no_contradiction(const LogOptions& options) {
    if (options.with_odometry) {
        return;
    }
    std::string about_odometry;
    for (const auto& [name, is_given] : {std::pair{"--odom-topic", !options.odom_topic.empty()},
                                         {"--odom-path", options.odom_path > 0},
                                         {"--odom-delay", options.odom_delay_s.has_value()},
                                         {"--imu-topic", !options.imu_topic.empty() && options.imu_topic != "none"}}) {
        about_odometry = about_odometry.empty() && is_given ? name : about_odometry;
    }
    if (!about_odometry.empty()) {
        throw UsageError("--odometry none leaves out the odometry, but " + about_odometry +
                         " says how to use it; expected one of the two");
    }
}

}  // namespace

const std::vector<Setting>& log_setting_list() { return log_rows().settings(); }

Json default_log_settings() { return log_rows().json({}); }

LogOptions log_options(const Json& log_settings) {
    LogOptions options = log_rows().checked(log_settings, "log");
    if (options.height && !(options.height->min_m < options.height->max_m)) {
        throw UsageError("log.height: expected the lower height first, and a higher one behind it");
    }
    expect_yaw_in_radians(options);
    expect_no_contradiction(options);
    return options;
}

}  // namespace ddtool

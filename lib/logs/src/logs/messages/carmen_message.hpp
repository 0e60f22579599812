#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "ddtool/robot/laser_scan.hpp"
#include "ddtool/robot/pose2.hpp"

namespace ddtool {

/// One scan message of a CARMEN log. The ranges are as logged, so that codes for a missing return are still among them.
struct CarmenScan {
    LaserScan scan;  ///< range_max_m is 0 if the message does not state it
    Pose2 odom_from_laser;
    Pose2 odom_from_robot;
    std::optional<std::int64_t> logger_time_ns;  ///< since the logger was started
};

/// What a line was found to be.
struct CarmenLine {
    std::optional<CarmenScan> scan;
    std::string fault;  ///< why there is no scan: "word 7 is '1,53', expected a range in metres with a decimal point"
};

/// Parses "FLASER n r1..rn x y theta odom_x odom_y odom_theta ipc_time host logger_time" without its first word. Beams
/// run from right to left, and their spacing follows CARMEN's table for SICK lasers: 1 degree for 180 and 181 readings,
/// 0.5 for 360 and 361, both from -90 degrees on (an even count lacks the last beam), 0.25 from -50 degrees on for 400
/// and 401, and for any other count 180 degrees divided by n - 1. A reading may also be inf or nan. Gives a fault if a
/// number is missing or invalid.
CarmenLine parse_flaser(std::string_view words);

/// Whether a scan of so many beams is one of a SICK laser, in CARMEN's table.
bool is_sick_view(std::size_t beams);

/// Parses "ROBOTLASER1 type start_angle fov resolution max_range accuracy remission_mode n r1..rn m e1..em laser_pose
/// robot_pose tv rv forward_safety side_safety turn_axis ipc_time host logger_time" without its first word. A
/// reading may also be inf or nan. Gives a fault if a number is missing or invalid.
CarmenLine parse_robotlaser(std::string_view words);

/// Whether these first bytes of a file begin a CARMEN log, that is, contain a line that starts with the name of one of
/// its messages.
bool looks_like_carmen(std::string_view head);

}  // namespace ddtool

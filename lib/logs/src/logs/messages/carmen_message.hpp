#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "ddtool/robot/laser_scan.hpp"
#include "ddtool/robot/pose2.hpp"

namespace ddtool {

/// One scan line of a CARMEN log. Ranges are as logged: no-return codes are still in them.
struct CarmenScan {
    LaserScan scan;  ///< range_max_m is 0 where the message does not say
    Pose2 odom_from_laser;
    Pose2 odom_from_robot;
};

/// "FLASER n r1..rn x y theta odom_x odom_y odom_theta ipc_time host logger_time", without its first word. Beams run
/// from right to left; their spacing follows CARMEN's table for SICK lasers: 1 degree for 180 and 181 readings, 0.5
/// for 360 and 361, both from -90 degrees (an even count lacks the last beam), 0.25 from -50 degrees for 400 and
/// 401, and else 180 degrees over n - 1. None when a number is missing or wrong.
std::optional<CarmenScan> parse_flaser(std::string_view words);

/// "ROBOTLASER1 type start_angle fov resolution max_range accuracy remission_mode n r1..rn m e1..em laser_pose
/// robot_pose tv rv forward_safety side_safety turn_axis ipc_time host logger_time", without its first word.
std::optional<CarmenScan> parse_robotlaser(std::string_view words);

/// Do these first bytes of a file begin a CARMEN log? (A line that starts with one of its message names.)
bool looks_like_carmen(std::string_view head);

}  // namespace ddtool

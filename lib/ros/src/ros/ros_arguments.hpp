#pragma once

#include <string>
#include <utility>
#include <vector>

namespace ddtool {

/// What stands after --ros-args on the command line of a ROS 2 node (https://design.ros2.org/articles/
/// ros_command_line_arguments.html): its name, its namespace, other names for topics, and parameters.
struct RosArguments {
    std::string node = "ddtool";
    std::string name_space = "/";                                 ///< absolute
    std::vector<std::pair<std::string, std::string>> remappings;  ///< as typed; the first that fits a name counts
    bool use_sim_time = false;
    double transform_tolerance_s = 0.2;  ///< by how much map -> odom is stamped ahead
};

/// Reads the words after --ros-args: -r or --remap FROM:=TO, also with __node and __ns, and -p or --param NAME:=VALUE.
/// Throws UsageError that names the word and what was expected.
RosArguments parse_ros_arguments(const std::vector<std::string>& words);

/// The absolute name of a topic: the name as the node knows it, relative to its namespace unless it begins with '/' (or
/// with "~/" relative to the node), and remapped.
std::string resolved_topic(const RosArguments& arguments, const std::string& name);

}  // namespace ddtool

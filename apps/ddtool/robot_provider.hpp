#pragma once

#include <memory>
#include <string>
#include <vector>

#include "run/robot_link.hpp"

namespace ddtool {

/// Joins a robot of ROS 2; `arguments` are the words after --ros-args. ddtool-ros contains what this needs. ddtool does
/// not: it replaces itself by ddtool-ros, with the same arguments.
std::unique_ptr<RobotLink> join_robot(const std::vector<std::string>& arguments);

}  // namespace ddtool

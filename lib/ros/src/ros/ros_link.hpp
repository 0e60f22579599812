#pragma once

#include <memory>
#include <string>
#include <vector>

#include "run/robot_link.hpp"

namespace ddtool {

/// Joins the ROS 2 programs of a robot, as a node that they see (docs/ros.md): reads its scans, odometry and
/// transforms, and publishes map -> odom, the map, the pose, the particles, the degree of degeneracy and diagnostics.
/// Which robot, the environment says as it does for ROS 2 programs (ros_environment.hpp). \param ros_arguments the
/// words after --ros-args Throws UsageError for arguments or an environment that make no sense, and Error if DDS does
/// not work here.
std::unique_ptr<RobotLink> join_ros(const std::vector<std::string>& ros_arguments);

}  // namespace ddtool

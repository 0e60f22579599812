#pragma once

#include <string>
#include <vector>

namespace ddtool {

/// What the name of a topic or a frame says by convention. Names are compared word by word, ignoring case; words are
/// separated by anything that is not a letter or a digit: "/robot/ground_truth/odom" has the words robot, ground,
/// truth, odom.

/// Whether the name has the words "ground truth", or the word "groundtruth" or "gt".
bool names_ground_truth(const std::string& name);
/// Whether the name has a word that begins with "odom".
bool names_odometry(const std::string& name);
/// Whether the name is that of what is asked of the robot or told to it, or of a pose in a map, none of which is
/// odometry: it has one of the words cmd, command, teleop, joy, goal, target, setpoint, desired, initialpose, amcl,
/// map.
bool names_no_measurement(const std::string& name);
/// Whether the name has the word "static".
bool names_static(const std::string& name);
/// Whether the name is that of a frame that does not move with the robot: odom, map, world or earth.
bool names_fixed_frame(const std::string& name);

/// The topics in an option, which are separated by commas.
std::vector<std::string> topics_named(const std::string& option);

/// The namespace of a robot's own transforms: "/robot1" of "/robot1/tf" and "/robot1/tf_static"; empty for every other
/// topic, whose transforms are for all robots.
std::string transform_namespace(const std::string& topic);
/// Whether the topic lies in the namespace: "/robot1/front/scan" in "/robot1". All topics lie in the empty one.
bool is_in_namespace(const std::string& topic, const std::string& name);

}  // namespace ddtool

#pragma once

#include <string>

namespace ddtool {

/// What a topic's or frame's name says by custom. Names are compared word by word, without case; words are parted by
/// anything that is no letter or digit: "/robot/ground_truth/odom" has the words robot, ground, truth, odom.

/// Has the words "ground truth", or "groundtruth" or "gt".
bool names_ground_truth(const std::string& name);
/// Has a word that begins with "odom".
bool names_odometry(const std::string& name);
/// Has the word "static".
bool names_static(const std::string& name);
/// A frame that does not move with the robot: odom, map, world or earth.
bool names_fixed_frame(const std::string& name);

}  // namespace ddtool

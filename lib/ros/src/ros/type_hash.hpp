#pragma once

#include <string_view>

namespace ddtool {

/// The hash of a ROS 2 message type of ros_messages.hpp, such as "RIHS01_64c1...": SHA-256 of its description in JSON
/// (REP 2016). ROS 2 shows it since Iron to tell types of the same name apart. Empty for a type that is not exchanged
/// with a robot.
std::string_view type_hash(std::string_view type_name);

}  // namespace ddtool

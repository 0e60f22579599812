#pragma once

#include <string>
#include <string_view>

namespace ddtool {

/// The full definition of a message type of ros_messages.hpp, e.g. "nav_msgs/msg/Path", in the form of MCAP's schema
/// encoding "ros2msg": its own text, then the text of every type that it uses, separated by lines of 80 '='.
std::string ros2_schema(std::string_view type_name);

}  // namespace ddtool

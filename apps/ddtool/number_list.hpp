#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "ddtool/robot/pose2.hpp"

namespace ddtool {

inline constexpr const char* saved_map_help =
    "A map: map.ddmap of a run, the map.yaml of a map of map_server or nav2, or the folder with either";

/// The value of an option that is a list of numbers separated by commas.
/// \param form how the list is written, for the message
/// Throws UsageError naming the option if it is none of `count` finite numbers.
std::vector<double> number_list(const std::string& option, const std::string& text, const std::string& form,
                                std::size_t count);

/// The value of an option that is a pose: x and y in metres, yaw in radians. Throws UsageError as number_list() does.
Pose2 pose_option(const std::string& option, const std::string& text);

}  // namespace ddtool

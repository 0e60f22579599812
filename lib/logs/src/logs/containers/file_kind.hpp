#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace ddtool {

/// The first bytes of the binary logs that can be read.
inline constexpr std::string_view mcap_start = "\x89MCAP";
inline constexpr std::string_view bag_start = "#ROSBAG";
inline constexpr std::string_view sqlite_magic{"SQLite format 3\0", 16};

/// Describes a file of an unexpected kind by its first bytes, as the end of a sentence, with what to do about it where
/// that is known: "starts like a ROS 1 bag". Eight bytes are enough for what is not text.
std::string describe_file_start(std::span<const std::byte> start);

}  // namespace ddtool

#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace ddtool {

/// How the binary logs begin that are read here.
inline constexpr std::string_view mcap_start = "\x89MCAP";
inline constexpr std::string_view bag_start = "#ROSBAG";
inline constexpr std::string_view sqlite_magic{"SQLite format 3\0", 16};

/// The first `size` bytes, or all of a smaller file; empty for one that cannot be read.
std::string read_file_start(const std::filesystem::path& path, std::size_t size);

/// What a file of another kind than expected looks like, from its first bytes (8 are enough), as the end of a sentence:
/// "starts like a ROS 1 bag".
std::string describe_file_start(std::span<const std::byte> start);

}  // namespace ddtool

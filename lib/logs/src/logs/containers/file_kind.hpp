#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace ddtool {

/// The first bytes of the binary logs that can be read.
inline constexpr std::string_view mcap_start = "\x89MCAP";
inline constexpr std::string_view bag_start = "#ROSBAG";
inline constexpr std::string_view sqlite_magic{"SQLite format 3\0", 16};

/// The first `size` bytes of a file, or all bytes of a smaller file; empty if the file cannot be read.
std::string read_file_start(const std::filesystem::path& path, std::size_t size);

/// Describes a file of an unexpected kind by its first bytes (8 are enough), as the end of a sentence: "starts like a
/// ROS 1 bag".
std::string describe_file_start(std::span<const std::byte> start);

}  // namespace ddtool

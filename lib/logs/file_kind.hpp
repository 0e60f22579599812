#pragma once

#include <cstddef>
#include <span>
#include <string>

namespace ddtool {

/// What a file of another kind than expected looks like, from its first bytes (8 are enough), as the end of a sentence:
/// "starts like a ROS 1 bag".
std::string describe_file_start(std::span<const std::byte> start);

}  // namespace ddtool

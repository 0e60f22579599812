#pragma once

#include <filesystem>
#include <functional>
#include <string_view>

namespace ddtool {

/// Calls take(line) for every line of a text file that is neither blank nor a comment (first character '#'). Throws
/// Error naming the file if it cannot be read, and Error naming the file, the line and `expected` if take returns
/// false.
void for_each_row(const std::filesystem::path& path, std::string_view expected,
                  const std::function<bool(std::string_view line)>& take);

}  // namespace ddtool

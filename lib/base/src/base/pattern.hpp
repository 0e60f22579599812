#pragma once

#include <cstdint>
#include <string>

namespace ddtool {

/// The text with {world} and {seed} replaced.
std::string expand(std::string text, const std::string& world, std::uint64_t seed);

/// The name with everything but letters, digits, '.', '_' and '-' replaced by '_': safe as part of a file's name.
std::string file_name_of(const std::string& name);

}  // namespace ddtool

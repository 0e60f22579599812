#pragma once

#include <string_view>
#include <vector>

namespace ddtool::sim {

/// The files of data/worlds, which are built into the program: JSON texts, in the order of the names of the worlds.
const std::vector<std::string_view>& builtin_worlds();

}  // namespace ddtool::sim

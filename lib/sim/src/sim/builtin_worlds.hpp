#pragma once

#include <string_view>
#include <vector>

namespace ddtool::sim {

/// The files of data/worlds, built into the program: JSON texts, in the order of their names.
const std::vector<std::string_view>& builtin_worlds();

}  // namespace ddtool::sim

#pragma once

#include <string>

#include "ddtool/system/settings.hpp"
#include "sim/world.hpp"

namespace ddtool::sim {

/// Reads a world in the form of its file (docs/simulator.md lists the keys).
/// \param source names the file in messages
/// Throws UsageError naming `source`, the key and what was expected.
World world_from_json(const Json& json, const std::string& source);

}  // namespace ddtool::sim

#pragma once

#include <string>

#include "ddtool/system/settings.hpp"
#include "sim/world.hpp"

namespace ddtool::sim {

/// A world as its file writes it (docs/simulator.md lists the keys). Throws UsageError naming `source`, the key and
/// what was expected.
World world_from_json(const Json& json, const std::string& source);

}  // namespace ddtool::sim

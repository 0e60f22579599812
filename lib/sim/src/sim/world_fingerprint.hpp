#pragma once

#include <string>

#include "sim/world.hpp"

namespace ddtool::sim {

/// Fingerprint of what a simulation depends on: walls, arcs and the route, not names.
std::string world_fingerprint(const World& world);

}  // namespace ddtool::sim

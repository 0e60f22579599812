#pragma once

#include <string>

#include "sim/world.hpp"

namespace ddtool::sim {

/// Fingerprint of everything in a world that a simulation depends on: walls, arcs and the route, but not names.
std::string world_fingerprint(const World& world);

}  // namespace ddtool::sim

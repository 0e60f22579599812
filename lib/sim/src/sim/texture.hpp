#pragma once

#include "sim/world.hpp"

namespace ddtool::sim {

/// The world with the details that the smooth walls of a simulation lack: door recesses (8 to 15 cm deep), skirting
/// boards (1.5 cm) and pillars (8 to 15 cm) along walls of 2 m and more, and rough outlines in place of perfect
/// circles. Recesses lead away from the route, skirting boards and pillars stand out towards it. The layout belongs to
/// the world: it is the same for every seed of a run.
World textured(const World& world);

}  // namespace ddtool::sim

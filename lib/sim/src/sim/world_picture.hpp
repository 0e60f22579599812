#pragma once

#include <filesystem>

#include "ddtool/robot/trajectory.hpp"
#include "sim/world.hpp"

namespace ddtool::sim {

/// Draws a world as a PNG: walls black, the driven path blue, way points red, the start green. North (y) is up; the
/// longer side has about 1600 pixels.
void write_world_picture(const std::filesystem::path& file, const World& world, const Trajectory& driven);

}  // namespace ddtool::sim

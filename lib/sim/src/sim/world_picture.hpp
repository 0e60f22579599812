#pragma once

#include <filesystem>

#include "ddtool/robot/trajectory.hpp"
#include "sim/world.hpp"

namespace ddtool::sim {

/// Draws a world as a PNG: walls black, the driven path blue, way points red, the start green. The y axis points up;
/// the longer side has about 1600 pixels. Throws Error naming the file if it cannot be written.
void write_world_picture(const std::filesystem::path& file, const World& world, const Trajectory& driven);

}  // namespace ddtool::sim

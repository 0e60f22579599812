#pragma once

#include <filesystem>

#include "ddtool/robot/trajectory.hpp"
#include "report/map_raster.hpp"

namespace ddtool {

/// A picture of a map with the path on it: start green, end red, and a scale bar below. Throws Error naming the file.
void write_map_picture(const std::filesystem::path& file, const MapRaster& map, const Trajectory& path);

}  // namespace ddtool

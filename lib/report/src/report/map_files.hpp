#pragma once

#include <filesystem>

#include "report/map_raster.hpp"

namespace ddtool {

/// Writes folder/NAME.pgm and folder/NAME.yaml, as ROS's map_server and nav2 read them, in trinary mode: the
/// greys of map_grey(). The origin is the lower left corner of the picture. Throws Error.
void write_map_files(const std::filesystem::path& folder, const std::string& name, const MapRaster& map);

}  // namespace ddtool

#pragma once

#include <filesystem>

#include "maps/saved_map.hpp"

namespace ddtool::maps {

/// Reads a map of ROS's map_server or nav2: a YAML file that names a picture (PGM or PNG) beside it. Every field is
/// honoured: resolution, origin with its yaw, negate, occupied_thresh, free_thresh, and the modes trinary, scale and
/// raw. The result has a grid alone, in which a cell is as certain as its value is far from a half. With a yaw, cells
/// are turned into those of the grid. Throws Error naming the file, the key and what was expected, and MapTooLarge.
SavedMap read_map_server(const std::filesystem::path& yaml);

}  // namespace ddtool::maps

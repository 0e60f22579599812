#pragma once

#include <filesystem>

#include "maps/map_file.hpp"

namespace ddtool::maps {

/// Reads a map file, a YAML file of map_server, or from the folder of a run the one or the other. Throws Error that
/// names the file and says what was expected.
SavedMap read_any_map(const std::filesystem::path& file, MapParts parts = MapParts::all);

}  // namespace ddtool::maps

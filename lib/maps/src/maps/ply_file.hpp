#pragma once

#include <filesystem>

#include "maps/saved_map.hpp"

namespace ddtool::maps {

/// Writes the points of all scans as a point cloud (PLY, binary, little-endian: x, y, z, nx, ny, nz in the map, and the
/// number of the scan), for CloudCompare, MeshLab, Open3D and others. z is 0. Throws OutputError naming the file.
void write_ply(const std::filesystem::path& file, const SavedMap& map);

}  // namespace ddtool::maps

#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "ddtool/system/settings.hpp"
#include "logs/stream/ros2_writer.hpp"
#include "maps/saved_map.hpp"

namespace ddtool::maps {

/// The version of the format that is written, and the latest that is read.
inline constexpr std::uint32_t map_format = 1;

/// Writes a map file (docs/formats/map-file.md). The scans are written as they come, so that memory does not grow with
/// them; what is only known at the end follows. The file appears under its name when it is complete. Throws
/// OutputError naming the file.
class MapFileWriter {
public:
    /// \param program what writes it, with its version
    MapFileWriter(const std::filesystem::path& file, const std::string& program, const Json& settings,
                  const OccupancySettings& cells);

    void add(const graph::Node& scan, std::uint32_t drive);
    /// Completes the file. If this is never called, no file is left behind.
    /// \param poses map_from_robot of the scans in the order in which they were added; scans without a pose are no
    ///     part of the map
    void finish(const std::vector<Drive>& drives, const std::vector<Pose2>& poses, const std::vector<MapEdge>& edges,
                const OccupancyGrid& grid);

private:
    Ros2Writer file_;
    std::int64_t stamp_ns_ = 0;  ///< of the latest scan, for what has no stamp
    std::uint64_t scans_ = 0;    ///< added so far
};

/// Writes a whole map. `program` is what writes it now.
void write_map(const std::filesystem::path& file, const std::string& program, const SavedMap& map);

/// Whether a file begins like one that could be a map file (MCAP).
bool looks_like_map_file(const std::filesystem::path& file);

enum class MapParts { all, grid };

/// Reads a map file. Throws Error naming the file, the place and what was expected if it is no map file, of a later
/// format, damaged or cut off. With MapParts::grid the scans and edges are checked for damage as bytes but not
/// taken in.
/// \param most_memory_mib the limit of the grid, as OccupancySettings has it
SavedMap read_map(const std::filesystem::path& file, MapParts parts = MapParts::all, std::uint64_t most_memory_mib = 0);

}  // namespace ddtool::maps

#pragma once

#include <cstddef>
#include <vector>

#include "maps/going_on.hpp"
#include "maps/saved_map.hpp"

namespace ddtool::merging {

struct Added {
    std::size_t seams = 0;    ///< edges to the scans of before
    std::size_t dropped = 0;  ///< scans of before that the drive made needless
};

/// Adds a drive to the map with which it went on. The graph then has the edges of before (of the odometry, if there
/// were none), those of the drive's odometry, and edges from the drive's scans to those of before where both show the
/// same walls. Poses stay as they are. Throws MapTooLarge. \param drive its nodes have poses in the map, and any number
/// as their drive \param grid the map as it is after the drive
Added add_drive(maps::SavedMap& map, const maps::Drive& drive, std::vector<maps::MapNode> nodes, OccupancyGrid grid,
                const maps::GoingOnSettings& settings);

}  // namespace ddtool::merging

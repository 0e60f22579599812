#pragma once

#include <cstddef>

#include "maps/saved_map.hpp"

namespace ddtool::maps {

/// Takes out scans of earlier drives that later ones make needless, so that a map does not grow with every drive
/// through the same place: those of whose view, the ground that the beams crossed and ended in, 95 % was also observed
/// by at least `covering_scans` later scans that stay. The latest drive keeps all of its scans. Where a scan is taken
/// out of a chain of odometry edges, an edge between its neighbours takes their place; drives without scans are
/// dropped. The grid stays as it is. Returns how many scans were taken out.
std::size_t thin(SavedMap& map, std::size_t covering_scans);

}  // namespace ddtool::maps

#pragma once

#include <cstddef>

#include "maps/saved_map.hpp"

namespace ddtool::merging {

struct Merged {
    explicit Merged(maps::SavedMap joined) : map(std::move(joined)) {}

    maps::SavedMap map;         ///< in the frame of the first
    Pose2 first_from_second;    ///< where the second map's origin lies, by the middle of what both share
    std::size_t compared = 0;   ///< windows of the second map
    std::size_t agreeing = 0;   ///< of those, the ones that lie on what the first shows
    std::size_t seams = 0;      ///< edges between the two
    double agreed = 0.0;        ///< the share of the walls in ground known to both that agree
    double most_moved_m = 0.0;  ///< by how much the poses of the first map were moved at most
};

/// Makes one map of two that show the same place in part. It has the nodes, drives and edges of both, and edges between
/// them; its origin is that of the first, and where something changed, the second counts as the later one. The cells
/// are those of the first. Throws Error that says why in a few words if a map has no scans, if they have a drive in
/// common, or if one cannot be sure of the place; and MapTooLarge.
Merged merged(const maps::SavedMap& first, const maps::SavedMap& second);

}  // namespace ddtool::merging

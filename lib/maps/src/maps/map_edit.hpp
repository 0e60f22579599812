#pragma once

#include <cstddef>
#include <vector>

#include "maps/saved_map.hpp"

namespace ddtool::maps {

/// A rectangle in the map, in metres.
struct Area {
    double x_min_m = 0.0, y_min_m = 0.0, x_max_m = 0.0, y_max_m = 0.0;

    [[nodiscard]] bool holds(const Point2& point) const {
        return point.x_m >= x_min_m && point.x_m <= x_max_m && point.y_m >= y_min_m && point.y_m <= y_max_m;
    }
};

/// Keeps some of the nodes, and the edges between these.
/// \param kept for each node of the map
void keep_nodes(SavedMap& map, const std::vector<bool>& kept);

/// Takes out what lies outside of the area: cells, scans that were taken there, and the points of the others that end
/// there, so that a map drawn anew has the same limits. Returns how many scans are left.
std::size_t crop(SavedMap& map, const Area& area);

/// Makes the pose `origin` of the map its origin: everything is moved by its inverse, and the grid is drawn anew.
/// Without scans, whose grid cannot be drawn anew, the cells are moved, which blurs them by up to half a cell. Throws
/// MapTooLarge.
void set_origin(SavedMap& map, const Pose2& origin);

/// Takes out the points of cells that at least `see_throughs` later scans saw through since a scan last hit them, such
/// as those of people and of doors that were closed later, and draws the grid anew. Walls stay: they are hit again.
/// Returns the number of cells that are no longer occupied. Throws Error if the map has no scans.
std::size_t remove_ghosts(SavedMap& map, int see_throughs);

/// The most see-throughs that remove_ghosts() can count.
inline constexpr int most_see_throughs = 26;

}  // namespace ddtool::maps

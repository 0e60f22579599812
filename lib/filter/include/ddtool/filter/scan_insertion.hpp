#pragma once

#include <cstddef>
#include <vector>

#include "ddtool/filter/free_space.hpp"
#include "ddtool/filter/occupancy_grid.hpp"
#include "ddtool/robot/pose2.hpp"
#include "ddtool/robot/scan_points.hpp"

namespace ddtool {

/// Enters scans into grids. An object holds only buffers: each thread needs its own, which serves any number of grids.
class ScanInserter {
public:
    /// pose: world_from_robot. Throws MapTooLarge as OccupancyGrid::reserve() does.
    void insert(OccupancyGrid& grid, const ScanPoints& points, const Pose2& pose);

private:
    void project(const ScanPoints& points, const Pose2& pose, double cell_size_m);
    /// Enters what one laser saw to be free.
    /// \param laser_m in the world
    /// \param begin, end the points of that laser
    void add_free(OccupancyGrid& grid, const ScanPoints& points, const Point2& laser_m, std::size_t begin,
                  std::size_t end);
    void add_hits(OccupancyGrid& grid) const;

    /// Free space ends this far before a wall, so that the wall's own cells are not lowered.
    static constexpr double free_margin_cells = 0.8;

    FreeSpace free_space_{free_margin_cells};
    std::vector<Point2> ends_cells_;
};

}  // namespace ddtool

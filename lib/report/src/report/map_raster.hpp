#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "ddtool/filter/occupancy_grid.hpp"
#include "ddtool/robot/pose2.hpp"

namespace ddtool {

/// A map as nav_msgs/OccupancyGrid has it: what was observed and nothing around it.
struct MapRaster {
    static constexpr std::int8_t unknown = -1;
    static constexpr std::int8_t free = 0;
    static constexpr std::int8_t occupied = 100;

    std::size_t width = 0;  ///< cells in x
    std::size_t height = 0;
    double cell_size_m = 0.05;
    Point2 origin_m;                 ///< the lower left corner of the first cell, in the world
    std::vector<std::int8_t> cells;  ///< row by row, from the lowest y

    [[nodiscard]] double width_m() const { return static_cast<double>(width) * cell_size_m; }
    [[nodiscard]] double height_m() const { return static_cast<double>(height) * cell_size_m; }
};

/// The grey of a cell's value, in every picture of a map and in map files: 0, black, for occupied, 254, almost white,
/// for free, 205 for unknown. The levels are those that ROS's map_server reads in its trinary mode.
std::uint8_t map_grey(std::int8_t cell);

/// A pixel for each cell, by map_grey(), row by row from the highest y: as a picture is seen, north up.
std::vector<std::uint8_t> map_pixels(const MapRaster& map);

/// Never empty: one unknown cell stands for a grid in which nothing was observed, since map servers refuse less.
MapRaster map_raster(const OccupancyGrid& grid);

/// The log odds of the same cells in steps (OccupancySettings), in the same order; Patch::unknown where nothing was
/// observed.
std::vector<std::int8_t> log_odds_of(const OccupancyGrid& grid, const MapRaster& raster);

}  // namespace ddtool

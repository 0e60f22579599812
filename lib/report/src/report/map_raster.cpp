#include "report/map_raster.hpp"

#include <algorithm>
#include <cmath>

namespace ddtool {
namespace {

/// The smallest box that contains every observed cell.
CellBox tight_box(const OccupancyGrid& grid) {
    const CellBox patches = grid.observed_box();
    CellBox box{patches.x_max, patches.y_max, patches.x_min, patches.y_min};
    for (int y = patches.y_min; y < patches.y_max; ++y) {
        for (int x = patches.x_min; x < patches.x_max; ++x) {
            if (grid.log_odds({x, y}) != Patch::unknown) {
                box = {std::min(box.x_min, x), std::min(box.y_min, y), std::max(box.x_max, x + 1),
                       std::max(box.y_max, y + 1)};
            }
        }
    }
    return box.empty() ? CellBox{0, 0, 1, 1} : box;
}

std::int8_t cell_value(std::int8_t log_odds) {
    if (log_odds == Patch::unknown) {
        return MapRaster::unknown;
    }
    return log_odds > 0 ? MapRaster::occupied : MapRaster::free;
}

}  // namespace

std::uint8_t map_grey(std::int8_t cell) {
    if (cell == MapRaster::unknown) {
        return 205;
    }
    return cell == MapRaster::occupied ? 0 : 254;
}

std::vector<std::uint8_t> map_pixels(const MapRaster& map) {
    std::vector<std::uint8_t> pixels;
    pixels.reserve(map.cells.size());
    for (std::size_t row = map.height; row-- > 0;) {
        for (std::size_t column = 0; column < map.width; ++column) {
            pixels.push_back(map_grey(map.cells[row * map.width + column]));
        }
    }
    return pixels;
}

MapRaster map_raster(const OccupancyGrid& grid) {
    const CellBox box = tight_box(grid);
    MapRaster map{.width = static_cast<std::size_t>(box.x_max - box.x_min),
                  .height = static_cast<std::size_t>(box.y_max - box.y_min),
                  .cell_size_m = grid.cell_size_m(),
                  .origin_m = {box.x_min * grid.cell_size_m(), box.y_min * grid.cell_size_m()},
                  .cells = {}};
    map.cells.reserve(map.width * map.height);
    for (int y = box.y_min; y < box.y_max; ++y) {
        for (int x = box.x_min; x < box.x_max; ++x) {
            map.cells.push_back(cell_value(grid.log_odds({x, y})));
        }
    }
    return map;
}

std::vector<std::int8_t> log_odds_of(const OccupancyGrid& grid, const MapRaster& raster) {
    const int left = static_cast<int>(std::lround(raster.origin_m.x_m / raster.cell_size_m));
    const int bottom = static_cast<int>(std::lround(raster.origin_m.y_m / raster.cell_size_m));
    std::vector<std::int8_t> log_odds;
    log_odds.reserve(raster.cells.size());
    for (int y = bottom; y < bottom + static_cast<int>(raster.height); ++y) {
        for (int x = left; x < left + static_cast<int>(raster.width); ++x) {
            log_odds.push_back(grid.log_odds({x, y}));
        }
    }
    return log_odds;
}

}  // namespace ddtool

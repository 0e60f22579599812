#include "report/map_raster.hpp"

#include <algorithm>

namespace ddtool {
namespace {

/// The smallest box that holds every observed cell.
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

}  // namespace ddtool

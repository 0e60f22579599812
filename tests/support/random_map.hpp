#pragma once

#include <array>

#include "ddtool/base/random.hpp"
#include "report/map_raster.hpp"

namespace ddtool::test {

/// A map of random cells of all three kinds, whose corners are observed.
inline MapRaster random_map(std::size_t width, std::size_t height) {
    constexpr std::array values{MapRaster::unknown, MapRaster::free, MapRaster::occupied};
    RandomStream random{width, height};
    MapRaster map{.width = width, .height = height, .cell_size_m = 0.05, .origin_m = {-3.15, 1.2}, .cells = {}};
    for (std::size_t cell = 0; cell < width * height; ++cell) {
        map.cells.push_back(values.at(random.index(values.size())));
    }
    return map;
}

}  // namespace ddtool::test

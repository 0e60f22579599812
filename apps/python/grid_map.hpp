#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "py.hpp"
#include "report/map_raster.hpp"

namespace ddtool::python {

/// A map as Python sees it: a copy, which later updates do not change.
struct HeldMap {
    MapRaster raster;
    std::vector<std::int8_t> log_odds;

    explicit HeldMap(const OccupancyGrid& grid) : raster(map_raster(grid)), log_odds(log_odds_of(grid, raster)) {}
};

/// Registers ddtool.Map and ddtool.read_map().
void add_maps(py::module_& module);

}  // namespace ddtool::python

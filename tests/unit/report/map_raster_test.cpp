#include "report/map_raster.hpp"

#include <gtest/gtest.h>

namespace ddtool {
namespace {

OccupancyGrid grid_with_wall(int x, int y) {
    OccupancyGrid grid(OccupancySettings{});
    grid.reserve({x, y, x + 4, y + 3});
    grid.add_free(y + 1, x, x + 3);
    grid.add_hit({x + 3, y + 1}, {0, 0});
    grid.add_hit({x, y + 2}, {0, 0});
    return grid;
}

TEST(MapRaster, HoldsWhatWasObservedAndNoMore) {
    const MapRaster map = map_raster(grid_with_wall(10, -20));
    EXPECT_EQ(map.width, 4U);
    EXPECT_EQ(map.height, 2U);
    EXPECT_DOUBLE_EQ(map.origin_m.x_m, 0.5);
    EXPECT_DOUBLE_EQ(map.origin_m.y_m, -0.95);
    constexpr std::int8_t f = MapRaster::free;
    constexpr std::int8_t o = MapRaster::occupied;
    constexpr std::int8_t u = MapRaster::unknown;
    EXPECT_EQ(map.cells, (std::vector<std::int8_t>{f, f, f, o, o, u, u, u}));
}

TEST(MapRaster, ComesWithTheLogOddsOfItsCells) {
    const OccupancyGrid grid = grid_with_wall(10, -20);
    const OccupancySettings steps;
    const auto free = static_cast<std::int8_t>(-steps.free_step);
    const auto hit = static_cast<std::int8_t>(steps.hit_step);
    EXPECT_EQ(log_odds_of(grid, map_raster(grid)),
              (std::vector<std::int8_t>{free, free, free, hit, hit, Patch::unknown, Patch::unknown, Patch::unknown}));
}

TEST(MapRaster, MovesWithWhatWasObserved) {
    const MapRaster map = map_raster(grid_with_wall(0, 0));
    const MapRaster moved = map_raster(grid_with_wall(-37, 65));
    EXPECT_EQ(moved.cells, map.cells);
    EXPECT_NEAR(moved.origin_m.x_m - map.origin_m.x_m, -37 * 0.05, 1e-12);
    EXPECT_NEAR(moved.origin_m.y_m - map.origin_m.y_m, 65 * 0.05, 1e-12);
}

TEST(MapPixels, AreGreysWithTheHighestRowFirst) {
    constexpr std::int8_t f = MapRaster::free;
    constexpr std::int8_t o = MapRaster::occupied;
    constexpr std::int8_t u = MapRaster::unknown;
    const MapRaster map{.width = 3, .height = 2, .origin_m = {}, .cells = {f, o, u, o, o, f}};
    EXPECT_EQ(map_pixels(map), (std::vector<std::uint8_t>{0, 0, 254, 254, 0, 205}));
}

TEST(MapRaster, IsOneUnknownCellWhereNothingWasObserved) {
    const MapRaster map = map_raster(OccupancyGrid(OccupancySettings{}));
    EXPECT_EQ(map.cells, std::vector<std::int8_t>{MapRaster::unknown});
    EXPECT_EQ(map.width * map.height, 1U);
}

}  // namespace
}  // namespace ddtool

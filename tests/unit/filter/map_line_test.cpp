#include "ddtool/filter/map_line.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <initializer_list>
#include <numbers>

namespace ddtool {
namespace {

constexpr double line_cell_m = 0.05;

struct WallPoint {
    double x, y;  ///< in cells
};

Cell containing(const WallPoint& point) {
    return {static_cast<int>(std::floor(point.x)), static_cast<int>(std::floor(point.y))};
}

/// A grid in which each point was hit so many times.
OccupancyGrid grid_of(std::initializer_list<WallPoint> points, int times) {
    OccupancyGrid grid(OccupancySettings{.cell_size_m = line_cell_m});
    grid.reserve({-20, -20, 20, 20});
    for (const WallPoint& point : points) {
        const auto offset = [](double cells) {
            return static_cast<std::int8_t>(std::floor((cells - std::floor(cells)) * NearestPoint::units_per_cell) -
                                            NearestPoint::units_per_cell / 2);
        };
        for (int i = 0; i < times; ++i) {
            grid.add_hit(containing(point), {offset(point.x), offset(point.y)});
        }
    }
    return grid;
}

MapLine line_at(const OccupancyGrid& grid, const WallPoint& point) {
    return MapLineFit(line_cell_m).through(grid, containing(point));
}

/// The distance of a line, as seen from the mean point of its cell, from where a wall through that point would have it,
/// in cells.
double distance_from_mean(const MapLine& line) {
    return std::abs(static_cast<double>(line.normal_x * line.x + line.normal_y * line.y));
}

TEST(MapLine, HasTheDirectionOfAWallHoweverItLies) {
    for (int degrees = 0; degrees < 180; degrees += 9) {
        const double angle = degrees * std::numbers::pi / 180.0;
        const double c = std::cos(angle);
        const double s = std::sin(angle);
        const WallPoint centre{0.4, 0.3};
        const auto on_wall = [&](double cells) { return WallPoint{centre.x + cells * c, centre.y + cells * s}; };
        const OccupancyGrid grid = grid_of({on_wall(-2.4), on_wall(-1.2), centre, on_wall(1.2), on_wall(2.4)}, 3);
        const MapLine line = line_at(grid, centre);
        ASSERT_TRUE(line.exists()) << degrees;
        EXPECT_NEAR(std::abs(-s * static_cast<double>(line.normal_x) + c * static_cast<double>(line.normal_y)), 1.0,
                    2e-3)
            << degrees;
        EXPECT_NEAR(std::hypot(line.normal_x, line.normal_y), 1.0, 1e-5) << degrees;
        EXPECT_LT(distance_from_mean(line), 0.05) << degrees;
    }
}

/// A wall on the border of two rows of cells, most of whose hits are in the upper row: the line must not lie in the
/// middle between the rows' means.
TEST(MapLine, WeighsCellsByTheirHits) {
    OccupancyGrid grid = grid_of({{-1.5, 0.1}, {-0.5, 0.1}, {0.5, 0.1}, {1.5, 0.1}}, 8);
    for (const int x : {-1, 0, 1}) {
        grid.add_hit({x, -1}, {0, NearestPoint::units_per_cell / 2 - 4});
    }
    const MapLine line = line_at(grid, {0.5, 0.1});
    ASSERT_TRUE(line.exists());
    EXPECT_LT(distance_from_mean(line), 0.05);
}

TEST(MapLine, IsNotThereInACorner) {
    const OccupancyGrid grid =
        grid_of({{0.5, 0.5}, {1.5, 0.5}, {2.5, 0.5}, {3.5, 0.5}, {0.5, 1.5}, {0.5, 2.5}, {0.5, 3.5}}, 3);
    EXPECT_FALSE(line_at(grid, {0.5, 0.5}).exists());
    EXPECT_TRUE(line_at(grid, {3.5, 0.5}).exists());
}

TEST(MapLine, NeedsThreeHitsAndMoreThanOneCell) {
    EXPECT_FALSE(line_at(grid_of({{0.5, 0.5}}, 9), {0.5, 0.5}).exists());
    EXPECT_FALSE(line_at(grid_of({{0.5, 0.5}, {1.5, 0.5}}, 1), {0.5, 0.5}).exists());
    EXPECT_TRUE(line_at(grid_of({{0.5, 0.5}, {1.5, 0.5}, {2.0, 0.5}}, 1), {0.5, 0.5}).exists());
}

TEST(MapLine, LooksNoFartherThanItsReach) {
    const OccupancyGrid near_alone = grid_of({{0.5, 0.5}, {1.5, 0.5}, {-0.5, 0.5}}, 3);
    const OccupancyGrid with_far = grid_of({{0.5, 0.5}, {1.5, 0.5}, {-0.5, 0.5}, {2.5, 2.5}, {-1.5, -1.5}}, 3);
    EXPECT_EQ(line_at(near_alone, {0.5, 0.5}).normal_x, line_at(with_far, {0.5, 0.5}).normal_x);
    EXPECT_EQ(line_at(near_alone, {0.5, 0.5}).normal_y, line_at(with_far, {0.5, 0.5}).normal_y);
}

TEST(KeptMapLines, FollowTheMap) {
    const WallPoint wall{0.5, 0.5};
    OccupancyGrid grid = grid_of({{-0.5, 0.5}, wall, {1.5, 0.5}}, 3);
    const OccupancyGrid before = grid;
    KeptMapLines lines(line_cell_m);
    const MapLine flat = lines.through(grid, containing(wall));
    EXPECT_EQ(flat.normal_x, lines.through(before, containing(wall)).normal_x);
    for (int i = 0; i < 3; ++i) {
        grid.add_hit({1, 0}, {0, 12});
    }
    const MapLine tilted = lines.through(grid, containing(wall));
    EXPECT_NE(flat.normal_x, tilted.normal_x);
    EXPECT_EQ(tilted.normal_x, MapLineFit(line_cell_m).through(grid, containing(wall)).normal_x);
    EXPECT_EQ(flat.normal_x, lines.through(before, containing(wall)).normal_x);
}

/// Far more cells than there is room for: none gets another's line.
TEST(KeptMapLines, AreThoseOfAFit) {
    OccupancyGrid grid(OccupancySettings{.cell_size_m = line_cell_m});
    grid.reserve({-200, -200, 200, 200});
    for (int x = -200; x < 200; ++x) {
        for (int y = -200; y < 200; ++y) {
            grid.add_hit({x, y},
                         {static_cast<std::int8_t>((7 * x + 3 * y) % 16), static_cast<std::int8_t>(x * y % 16)});
        }
    }
    KeptMapLines lines(line_cell_m);
    const MapLineFit fit(line_cell_m);
    for (int round = 0; round < 2; ++round) {
        for (int x = -190; x < 190; ++x) {
            for (int y = -190; y < 190; ++y) {
                const MapLine kept = lines.through(grid, {x, y});
                const MapLine right = fit.through(grid, {x, y});
                ASSERT_EQ(kept.normal_x, right.normal_x);
                ASSERT_EQ(kept.x, right.x);
            }
        }
    }
}

}  // namespace
}  // namespace ddtool

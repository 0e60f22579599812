#include "ddtool/filter/occupancy_grid.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <initializer_list>
#include <limits>
#include <map>
#include <utility>

#include "ddtool/base/random.hpp"

namespace ddtool {
namespace {

constexpr int radius = OccupancyGrid::field_radius;
constexpr int units = NearestPoint::units_per_cell;
/// A region that covers parts of four patches, on both sides of zero.
constexpr CellBox region{-10, -9, 8, 7};

void for_each_cell(const CellBox& box, const std::function<void(Cell)>& visit) {
    for (int y = box.y_min; y < box.y_max; ++y) {
        for (int x = box.x_min; x < box.x_max; ++x) {
            visit({x, y});
        }
    }
}

CellBox widened(const CellBox& box, int by) { return {box.x_min - by, box.y_min - by, box.x_max + by, box.y_max + by}; }

Cell random_cell(RandomStream& random) {
    return {region.x_min + static_cast<int>(random.index(region.x_max - region.x_min)),
            region.y_min + static_cast<int>(random.index(region.y_max - region.y_min))};
}

NearestPoint random_offset(RandomStream& random) {
    const auto part = [&] { return static_cast<std::int8_t>(static_cast<int>(random.index(units)) - units / 2); };
    const std::int8_t x = part();
    return {x, part()};
}

/// Adds hits and passes at random. `offset_of` gives the position of a hit within its cell.
void add_random_observation(OccupancyGrid& grid, RandomStream& random,
                            const std::function<NearestPoint(Cell)>& offset_of) {
    const Cell cell = random_cell(random);
    if (random.uniform() < 0.15) {
        grid.add_hit(cell, offset_of(cell));
    } else {
        grid.add_free(cell.y, cell.x, std::min(cell.x + 6, region.x_max));
    }
}

/// The vector from the centre of `cell` to the mean of the hits in `other`, in the field's units.
std::pair<int, int> seen_from(const OccupancyGrid& grid, Cell cell, Cell other) {
    const NearestPoint mean = grid.nearest(other);
    return {units * (other.x - cell.x) + mean.x, units * (other.y - cell.y) + mean.y};
}

/// The squared distance to the nearest mean of an occupied cell, found by a search around the cell; the largest int if
/// there is none.
int searched_distance(const OccupancyGrid& grid, Cell cell) {
    int least = std::numeric_limits<int>::max();
    for_each_cell(widened({cell.x, cell.y, cell.x + 1, cell.y + 1}, radius), [&](Cell other) {
        if (grid.occupied(other)) {
            const auto [x, y] = seen_from(grid, cell, other);
            least = std::min(least, x * x + y * y);
        }
    });
    return least;
}

int field_distance(const OccupancyGrid& grid, Cell cell) {
    const NearestPoint point = grid.nearest(cell);
    return point.none() ? std::numeric_limits<int>::max() : point.x * point.x + point.y * point.y;
}

bool field_points_at_a_mean(const OccupancyGrid& grid, Cell cell) {
    const NearestPoint point = grid.nearest(cell);
    bool found = point.none();
    for_each_cell(widened({cell.x, cell.y, cell.x + 1, cell.y + 1}, radius), [&](Cell other) {
        found =
            found || (grid.occupied(other) && seen_from(grid, cell, other) == std::pair<int, int>{point.x, point.y});
    });
    return found;
}

void expect_same_cells(const OccupancyGrid& a, const OccupancyGrid& b, const CellBox& box) {
    for_each_cell(box, [&](Cell cell) {
        ASSERT_EQ(a.log_odds(cell), b.log_odds(cell)) << cell.x << ' ' << cell.y;
        ASSERT_EQ(a.nearest(cell), b.nearest(cell)) << cell.x << ' ' << cell.y;
    });
}

OccupancyGrid observed_grid(std::uint64_t seed, int observations = 400) {
    RandomStream random{seed};
    OccupancyGrid grid{OccupancySettings{}};
    grid.reserve(region);
    for (int i = 0; i < observations; ++i) {
        add_random_observation(grid, random, [&](Cell) { return random_offset(random); });
    }
    return grid;
}

TEST(OccupancyField, IsTheNearestPointWhereHitsFallOnOnePointACell) {
    RandomStream random{1};
    std::map<std::pair<int, int>, NearestPoint> offsets;
    for_each_cell(region, [&](Cell cell) { offsets[{cell.x, cell.y}] = random_offset(random); });
    OccupancyGrid grid{OccupancySettings{}};
    grid.reserve(region);
    for (int i = 0; i < 600; ++i) {
        add_random_observation(grid, random, [&](Cell cell) { return offsets.at({cell.x, cell.y}); });
        for_each_cell(widened(region, radius + 1), [&](Cell cell) {
            ASSERT_EQ(field_distance(grid, cell), searched_distance(grid, cell)) << cell.x << ' ' << cell.y;
        });
    }
}

/// When a mean moves, the cells that point at it follow it. Another mean may then be nearer, but by no more than the
/// mean has moved within its cell.
TEST(OccupancyField, PointsAtAPresentMeanWhereMeansMove) {
    RandomStream random{2};
    OccupancyGrid grid{OccupancySettings{}};
    grid.reserve(region);
    for (int i = 0; i < 600; ++i) {
        add_random_observation(grid, random, [&](Cell) { return random_offset(random); });
        for_each_cell(widened(region, radius + 1), [&](Cell cell) {
            const int searched = searched_distance(grid, cell);
            ASSERT_EQ(grid.nearest(cell).none(), searched == std::numeric_limits<int>::max());
            ASSERT_TRUE(field_points_at_a_mean(grid, cell)) << cell.x << ' ' << cell.y;
            if (!grid.nearest(cell).none()) {
                ASSERT_LE(std::sqrt(field_distance(grid, cell)), std::sqrt(searched) + std::sqrt(2.0) * units);
            }
        });
    }
}

TEST(OccupancyField, OfAnOccupiedCellIsTheMeanOfItsHits) {
    OccupancyGrid grid{OccupancySettings{}};
    grid.reserve({0, 0, 1, 1});
    for (const std::int8_t x : std::initializer_list<std::int8_t>{-8, 4, 10}) {
        grid.add_hit({0, 0}, {x, static_cast<std::int8_t>(-x)});
    }
    EXPECT_EQ(grid.nearest({0, 0}), (NearestPoint{2, -2}));
    EXPECT_EQ(grid.nearest({2, -1}), (NearestPoint{2 - 2 * units, -2 + units}));
}

TEST(OccupancyGrid, LogOddsAreTheClampedSumOfSteps) {
    const OccupancySettings settings;
    RandomStream random{3};
    OccupancyGrid grid{settings};
    grid.reserve(region);
    std::map<std::pair<int, int>, int> expected;
    for (int i = 0; i < 3'000; ++i) {
        const Cell cell = random_cell(random);
        int& sum = expected[{cell.x, cell.y}];
        if (random.uniform() < 0.3) {
            grid.add_hit(cell, {});
            sum = std::min(sum + settings.hit_step, settings.max_log_odds);
        } else {
            grid.add_free(cell.y, cell.x, cell.x + 1);
            sum = std::max(sum - settings.free_step, settings.min_log_odds);
        }
    }
    for_each_cell(region, [&](Cell cell) {
        const auto found = expected.find({cell.x, cell.y});
        EXPECT_EQ(grid.log_odds(cell), found == expected.end() ? Patch::unknown : found->second);
    });
}

/// How many passing beams it takes until a cell with so many hits is free.
int passes_until_free(int hits, int half_life_scans) {
    OccupancyGrid grid{OccupancySettings{}};
    grid.reserve({0, 0, 1, 1});
    for (int hit = 0; hit < hits; ++hit) {
        grid.add_hit({0, 0}, {});
    }
    grid.fade(half_life_scans);
    int passes = 0;
    for (; grid.occupied({0, 0}); ++passes) {
        grid.add_free(0, 0, 1);
    }
    return passes;
}

TEST(OccupancyGrid, FadingWallsGoSooner) {
    EXPECT_EQ(passes_until_free(100, 0), OccupancySettings{}.max_log_odds);
    EXPECT_LT(passes_until_free(100, 5), 25);
    EXPECT_GT(passes_until_free(100, 5), 10);
    EXPECT_LT(passes_until_free(100, 2), passes_until_free(100, 5));
    // A single hit counts for as many passing beams as ever, so that it does not matter how walls come to be known.
    EXPECT_EQ(passes_until_free(1, 5), OccupancySettings{}.hit_step);
}

TEST(OccupancyGrid, GrowthInEveryDirectionKeepsTheContent) {
    const OccupancyGrid before = observed_grid(4);
    const CellBox wide = widened(region, 150);
    for (const CellBox& box : {CellBox{-140, 0, -139, 1}, CellBox{140, 0, 141, 1}, CellBox{0, -140, 1, -139},
                               CellBox{0, 140, 1, 141}, CellBox{-140, -140, 141, 141}, CellBox{-50, -50, 50, 50}}) {
        OccupancyGrid grid = before;
        grid.reserve(box);
        expect_same_cells(grid, before, wide);
        grid.add_hit({box.x_min, box.y_min}, {});
        EXPECT_TRUE(grid.occupied({box.x_min, box.y_min}));
    }
}

TEST(OccupancyGrid, DoesNotDependOnWhenItGrew) {
    const OccupancyGrid at_once = observed_grid(5);
    RandomStream random{5};
    OccupancyGrid bit_by_bit{OccupancySettings{}};
    for (int i = 0; i < 400; ++i) {
        bit_by_bit.reserve(widened(region, i / 4));
        add_random_observation(bit_by_bit, random, [&](Cell) { return random_offset(random); });
    }
    expect_same_cells(at_once, bit_by_bit, widened(region, 100));
}

TEST(OccupancyGrid, CopiesAreWrittenApart) {
    const OccupancyGrid original = observed_grid(6);
    const OccupancyGrid same = observed_grid(6);
    OccupancyGrid copy = original;
    RandomStream random{7};
    for (int i = 0; i < 200; ++i) {
        add_random_observation(copy, random, [&](Cell) { return random_offset(random); });
    }
    expect_same_cells(original, same, widened(region, 10));
}

TEST(ObservedBox, IsEmptyBeforeAnythingIsObserved) {
    OccupancyGrid grid{OccupancySettings{}};
    EXPECT_TRUE(grid.observed_box().empty());
    grid.reserve({-100, -100, 100, 100});
    EXPECT_TRUE(grid.observed_box().empty());
}

TEST(ObservedBox, IsOfTheWholePatchesSeen) {
    OccupancyGrid grid{OccupancySettings{}};
    grid.reserve({-200, -200, 200, 200});
    grid.add_free(-33, -70, -60);
    grid.add_free(5, 20, 40);
    const CellBox box = grid.observed_box();
    const auto patch_edge = [](int cell) { return (cell >> Patch::size_bits) * Patch::size_cells; };
    EXPECT_EQ(box.x_min, patch_edge(-70));
    EXPECT_EQ(box.y_min, patch_edge(-33));
    EXPECT_EQ(box.x_max, patch_edge(39) + Patch::size_cells);
    EXPECT_EQ(box.y_max, patch_edge(5) + Patch::size_cells);
}

}  // namespace
}  // namespace ddtool

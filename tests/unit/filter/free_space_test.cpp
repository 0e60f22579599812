#include "ddtool/filter/free_space.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

namespace ddtool {
namespace {

constexpr double margin_cells = 0.8;

using Counts = std::map<std::pair<int, int>, int>;

/// How often each cell is seen by neighbouring beams with these end points. All lengths are in cells.
Counts seen_cells(const std::vector<Point2>& ends, Point2 origin) {
    ScanPoints points;
    for (std::size_t i = 0; i < ends.size(); ++i) {
        points.order.push_back(static_cast<std::int32_t>(i));
    }
    FreeSpace free_space(margin_cells);
    Counts counts;
    for (const CellSpan& span : free_space.find(points, ends, origin)) {
        for (int x = span.x_begin; x < span.x_end; ++x) {
            ++counts[{x, span.y}];
        }
    }
    return counts;
}

/// The end points of a full turn of beams on the walls of a box from (0, 0) to (length, width).
std::vector<Point2> ends_on_box(double length, double width, Point2 origin, int beams) {
    std::vector<Point2> ends;
    for (int beam = 0; beam < beams; ++beam) {
        const double angle = -std::numbers::pi + 2.0 * std::numbers::pi * beam / (beams - 1);
        const double c = std::cos(angle);
        const double s = std::sin(angle);
        const double to_x = ((c > 0.0 ? length : 0.0) - origin.x_m) / c;
        const double to_y = ((s > 0.0 ? width : 0.0) - origin.y_m) / s;
        const double range = std::min(to_x, to_y);
        ends.push_back({origin.x_m + range * c, origin.y_m + range * s});
    }
    return ends;
}

constexpr Point2 laser{61.3, 33.8};

/// The distance from the centre of a cell to the nearest wall of the box, in cells.
double depth_cells(int x, int y) { return std::min({x + 0.5, y + 0.5, 150.0 - x - 0.5, 80.0 - y - 0.5}); }

constexpr double rim_cells = margin_cells + 1.0;

bool is_inner(int x, int y) { return depth_cells(x, y) > rim_cells; }

Counts without_rim(const Counts& counts, int shift_x, int shift_y) {
    Counts inner;
    for (const auto& [cell, count] : counts) {
        const std::pair<int, int> shifted{cell.first - shift_x, cell.second - shift_y};
        if (is_inner(shifted.first, shifted.second)) {
            inner[shifted] = count;
        }
    }
    return inner;
}

TEST(FreeSpace, OfARoomIsEveryInnerCellOnce) {
    const Counts counts = seen_cells(ends_on_box(150.0, 80.0, laser, 1'440), laser);
    for (int y = -3; y < 83; ++y) {
        for (int x = -3; x < 153; ++x) {
            const auto found = counts.find({x, y});
            const int count = found == counts.end() ? 0 : found->second;
            if (is_inner(x, y)) {
                EXPECT_EQ(count, 1) << x << ' ' << y;
            } else if (depth_cells(x, y) < 0.5 + 1e-9) {  // the cells in which the walls are
                EXPECT_EQ(count, 0) << x << ' ' << y;
            }
        }
    }
}

TEST(FreeSpace, MovesWithTheScan) {
    const std::vector<Point2> ends = ends_on_box(150.0, 80.0, laser, 720);
    std::vector<Point2> moved = ends;
    for (Point2& end : moved) {
        end = {end.x_m - 256.0, end.y_m + 512.0};
    }
    const Counts counts = seen_cells(moved, {laser.x_m - 256.0, laser.y_m + 512.0});
    EXPECT_EQ(without_rim(counts, -256, 512), without_rim(seen_cells(ends, laser), 0, 0));
}

TEST(FreeSpace, DoesNotDependOnTheWayRound) {
    std::vector<Point2> ends = ends_on_box(150.0, 80.0, laser, 720);
    const Counts forwards = seen_cells(ends, laser);
    std::reverse(ends.begin(), ends.end());
    EXPECT_EQ(without_rim(seen_cells(ends, laser), 0, 0), without_rim(forwards, 0, 0));
}

/// A plate at a distance of 20 cells, which covers a few beams, in front of a wall at a distance of 60 cells.
TEST(FreeSpace, EndsAtAnObstacle) {
    std::vector<Point2> ends;
    for (int beam = -100; beam <= 100; ++beam) {
        const double range_x = std::abs(beam) <= 20 ? 20.0 : 60.0;
        ends.push_back({range_x, range_x * beam / 200.0});
    }
    const Counts counts = seen_cells(ends, {0.0, 0.0});
    for (const auto& [cell, count] : counts) {
        const bool in_shadow = cell.first >= 20 && std::abs(cell.second + 0.5) < 0.1 * (cell.first + 0.5) - 0.75;
        EXPECT_FALSE(in_shadow) << cell.first << ' ' << cell.second;
    }
    EXPECT_TRUE(counts.contains({10, 0}));
    EXPECT_TRUE(counts.contains({50, 20}));
}

TEST(FreeSpace, OfNoBeamIsNothing) { EXPECT_TRUE(seen_cells({}, laser).empty()); }

TEST(FreeSpace, IsNotSpannedAcrossMissingBeams) {
    ScanPoints points;
    points.order = {0, 3};
    FreeSpace free_space(margin_cells);
    EXPECT_TRUE(free_space.find(points, {{20.0, -10.0}, {20.0, 10.0}}, {0.0, 0.0}).empty());
    points.order = {0, 1};
    EXPECT_FALSE(free_space.find(points, {{20.0, -10.0}, {20.0, 10.0}}, {0.0, 0.0}).empty());
}

}  // namespace
}  // namespace ddtool

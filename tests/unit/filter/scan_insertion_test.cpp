#include "ddtool/filter/scan_insertion.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "ddtool/base/random.hpp"
#include "room_scans.hpp"

namespace ddtool {
namespace {

OccupancyGrid grid_of_scan(const ScanPoints& points, const Pose2& pose) {
    OccupancyGrid grid{OccupancySettings{}};
    ScanInserter().insert(grid, points, pose);
    return grid;
}

template <class Visit>
void for_each_observed(const OccupancyGrid& grid, Visit&& visit) {
    const CellBox box = grid.observed_box();
    for (int y = box.y_min; y < box.y_max; ++y) {
        for (int x = box.x_min; x < box.x_max; ++x) {
            if (grid.log_odds({x, y}) != Patch::unknown) {
                visit(Cell{x, y});
            }
        }
    }
}

bool every_end_point_is_occupied(const OccupancyGrid& grid, const ScanPoints& points, const Pose2& pose) {
    bool occupied = true;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Point2 end = pose * Point2{static_cast<double>(points.x_m[i]), static_cast<double>(points.y_m[i])};
        occupied = occupied && grid.occupied({static_cast<int>(std::floor(end.x_m / grid.cell_size_m())),
                                              static_cast<int>(std::floor(end.y_m / grid.cell_size_m()))});
    }
    return occupied;
}

TEST(ScanInsertion, WallsStayHoweverOftenTheyAreSeen) {
    RandomStream random{1};
    for (const sim::World& world : {room(9.0, 7.0), room(60.0, 2.0), furnished_room()}) {
        for (int i = 0; i < 5; ++i) {
            const Pose2 pose{random.uniform(-1.5, 1.5), random.uniform(-0.7, 0.7), random.uniform(-3.0, 3.0)};
            const ScanPoints points = exact_points(world, pose, 360 + static_cast<int>(random.index(1'400)));
            OccupancyGrid grid{OccupancySettings{}};
            ScanInserter inserter;
            for (int scan = 0; scan < 12; ++scan) {
                inserter.insert(grid, points, pose);
                ASSERT_TRUE(every_end_point_is_occupied(grid, points, pose))
                    << pose.x_m << ' ' << pose.y_m << ' ' << scan;
            }
        }
    }
}

TEST(ScanInsertion, MarksEveryEndPointAndNothingBeyondTheWalls) {
    const Pose2 pose{0.7, -0.4, 0.3};
    const ScanPoints points = exact_points(room(9.0, 7.0), pose);
    const OccupancyGrid grid = grid_of_scan(points, pose);
    EXPECT_TRUE(every_end_point_is_occupied(grid, points, pose));
    for_each_observed(grid, [&](Cell cell) {
        const double beyond_m = std::max(std::abs(0.05 * (cell.x + 0.5)) - 4.5, std::abs(0.05 * (cell.y + 0.5)) - 3.5);
        EXPECT_LE(beyond_m, 0.026);
    });
}

TEST(ScanInsertion, FreesNothingBehindAnObstacle) {
    sim::World world = room(9.0, 7.0);
    sim::add_box(world, {2.0, 0.0, 0.0}, 0.4, 2.0);
    const OccupancyGrid grid = grid_of_scan(exact_points(world, {}), {});
    for_each_observed(grid, [&](Cell cell) {
        const double x_m = 0.05 * (cell.x + 0.5);
        const double y_m = 0.05 * (cell.y + 0.5);
        // This is the shadow of the box's front side, without a margin of one cell on each side.
        EXPECT_FALSE(x_m > 1.9 && std::abs(y_m) < x_m / 1.8 - 0.06) << x_m << ' ' << y_m;
    });
}

TEST(ScanInsertion, SeesMostOfTheRoom) {
    const OccupancyGrid grid = grid_of_scan(exact_points(room(9.0, 7.0), {}), {});
    double free_m2 = 0.0;
    for_each_observed(grid, [&](Cell cell) { free_m2 += grid.occupied(cell) ? 0.0 : 0.05 * 0.05; });
    EXPECT_NEAR(free_m2, 8.9 * 6.9, 0.02 * 63.0);
}

TEST(ScanInsertion, FieldIsOneScanUnitFromTheEndPoints) {
    const Pose2 pose{0.3, 0.2, -1.0};
    const ScanPoints points = exact_points(room(9.0, 7.0), pose);
    const OccupancyGrid grid = grid_of_scan(points, pose);
    const double unit_m = 0.05 / NearestPoint::units_per_cell;
    for_each_observed(grid, [&](Cell cell) {
        const NearestPoint nearest = grid.nearest(cell);
        if (grid.occupied(cell)) {
            const double x_m = 0.05 * (cell.x + 0.5) + unit_m * (nearest.x + 0.5);
            const double y_m = 0.05 * (cell.y + 0.5) + unit_m * (nearest.y + 0.5);
            EXPECT_LE(std::min(std::abs(std::abs(x_m) - 4.5), std::abs(std::abs(y_m) - 3.5)), unit_m);
        }
    });
}

TEST(ScanInsertion, OfAScanWithoutReturnsObservesNothing) {
    OccupancyGrid grid{OccupancySettings{}};
    ScanInserter().insert(grid, {}, {1.0, 2.0, 3.0});
    EXPECT_TRUE(grid.observed_box().empty());
}

/// A scan of the world by a lidar at another place on the robot.
SensorFrame seen_by(const sim::World& world, const Pose2& pose, const Pose2& robot_from_laser) {
    SensorFrame frame = exact_scan(world, pose * robot_from_laser, 720, 30.0);
    frame.robot_from_laser = robot_from_laser;
    frame.odom_from_robot = pose;
    return frame;
}

TEST(ScanInsertion, OfJoinedScansSeesWhatEachOfThemSees) {
    const sim::World world =
        room(9.06, 7.06);  // no wall, and no edge of the free space before it, is at the edge of a cell
    const Pose2 before{0.3, -0.5, 0.1};
    const Pose2 pose = before * Pose2{0.2, 0.0, 0.3};
    const SensorFrame rear = seen_by(world, before, {-0.4, 0.1, 3.0});
    SensorFrame front = seen_by(world, pose, {0.4, 0.0, 0.0});
    OccupancyGrid each = grid_of_scan(scan_points(front, {}), pose);
    ScanInserter().insert(each, scan_points(rear, {}), before);
    front.joined = {rear};
    const ScanPoints points = scan_points(front, {});
    const OccupancyGrid both = grid_of_scan(points, pose);
    EXPECT_TRUE(every_end_point_is_occupied(both, points, pose));
    std::size_t cells = 0;
    std::size_t different = 0;
    for_each_observed(each, [&](const Cell& cell) {
        ++cells;
        different += both.log_odds(cell) == Patch::unknown ? 1 : 0;
    });
    for_each_observed(both, [&](const Cell& cell) { different += each.log_odds(cell) == Patch::unknown ? 1 : 0; });
    EXPECT_GT(cells, 1000U);
    EXPECT_LT(different, cells / 2000);
}

}  // namespace
}  // namespace ddtool

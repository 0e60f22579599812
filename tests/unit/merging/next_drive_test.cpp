#include "merging/next_drive.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "ddtool/methods/method.hpp"
#include "driven_maps.hpp"
#include "localization/localizer.hpp"

namespace ddtool::merging {
namespace {

using test::map_of;

maps::Drive drive_named(const char* log) { return {.log = log, .odometry = {}}; }

Added add(maps::SavedMap& map, std::uint64_t seed, const maps::GoingOnSettings& settings) {
    const maps::SavedMap next = map_of(test::two_rooms(), seed, {}, test::anywhere);
    return add_drive(map, drive_named("next"), next.nodes, next.grid, settings);
}

TEST(NextDrive, IsTiedToTheDrivesOfBefore) {
    maps::SavedMap map = map_of(test::two_rooms(), 1, {}, test::anywhere);
    const std::size_t before = map.nodes.size();
    const Added added = add(map, 2, {.half_life_scans = 5, .covering_scans = 0});
    EXPECT_EQ(added.dropped, 0U);
    EXPECT_GT(added.seams, 5U);
    std::size_t of_odometry = 0;
    std::size_t between_both = 0;
    for (const maps::MapEdge& edge : map.edges) {
        of_odometry += edge.kind == maps::MapEdge::Kind::odometry ? 1 : 0;
        between_both += edge.edge.from < before && edge.edge.to >= before ? 1 : 0;
        const Pose2 seen = between(map.nodes[edge.edge.from].pose, map.nodes[edge.edge.to].pose);
        if (edge.kind == maps::MapEdge::Kind::loop) {  // the nodes stand at their true poses
            EXPECT_LT(distance_m(seen, edge.edge.measured), 0.05);
        }
    }
    EXPECT_EQ(between_both, added.seams);
    EXPECT_EQ(of_odometry, map.nodes.size() - 2);  // two chains
    EXPECT_EQ(map.drives.size(), 2U);
    EXPECT_EQ(map.nodes.back().drive, 1U);
}

TEST(NextDrive, TheMapDoesNotGrowWithEachDrive) {
    maps::SavedMap map = map_of(test::two_rooms(), 1, {}, test::anywhere);
    const std::size_t one_drive = map.nodes.size();
    for (std::uint64_t seed = 2; seed < 8; ++seed) {
        const Added added = add(map, seed, {});
        EXPECT_LT(map.nodes.size(), 3 * one_drive) << seed;
        EXPECT_EQ(map.nodes.front().drive, 0U);
        EXPECT_EQ(map.nodes.back().drive + 1, map.drives.size());
        EXPECT_GT(added.seams, 0U);
    }
    for (const maps::MapEdge& edge : map.edges) {
        EXPECT_LT(edge.edge.from, map.nodes.size());
        EXPECT_LT(edge.edge.to, map.nodes.size());
    }
}

std::size_t walls_in(const OccupancyGrid& grid, double x_m, double y_m, double half_m) {
    const double cell_m = grid.cell_size_m();
    std::size_t count = 0;
    for (int y = static_cast<int>((y_m - half_m) / cell_m); y < static_cast<int>((y_m + half_m) / cell_m); ++y) {
        for (int x = static_cast<int>((x_m - half_m) / cell_m); x < static_cast<int>((x_m + half_m) / cell_m); ++x) {
            count += grid.occupied({x, y}) ? 1 : 0;
        }
    }
    return count;
}

sim::World room_with_shelf(double x_m, double y_m) {
    sim::World world{.name = "shelf", .description = "", .segments = {}, .arcs = {}, .route = {}};
    sim::add_polyline(world,
                      {{-3, -3}, {5, -3}, {5, 3.5}, {1, 3.5}, {1, 4.5}, {-1, 4.5}, {-1, 3.5}, {-3, 3.5}, {-3, -3}});
    sim::add_box(world, {x_m, y_m, 0.0}, 0.8, 0.4);
    world.route = {.start = {}, .way_points = {{2.0, 0.0}, {2.0, 1.5}, {-1.0, 1.5}, {-1.0, 0.0}}};
    return world;
}

/// A shelf stood at one place when the map was made, and stands at another one now.
TEST(NextDrive, WhatWasMovedReplacesWhatWas) {
    const maps::SavedMap map = map_of(room_with_shelf(3.5, 2.5), 1, {}, test::anywhere);
    ASSERT_GT(walls_in(map.grid, 3.5, 2.5, 0.6), 10U);
    ASSERT_EQ(walls_in(map.grid, 0.5, -2.0, 0.6), 0U);
    const auto after = [&](int half_life_scans) {
        auto grid = std::make_shared<OccupancyGrid>(map.grid);
        grid->fade(half_life_scans);
        RbpfSettings settings;
        settings.particles = 5;
        ThreadPool threads(1);
        localization::Localizer localizer(settings, {}, threads, make_strategies({}, {}), grid,
                                          localization::StartPose{.pose = {}, .sd_m = 0.1, .sd_rad = 0.05},
                                          localization::MapUse::going_on);
        sim::SimulationSettings sensors;
        sensors.seed = 2;
        sensors.lidar.beams = 180;
        sensors.lidar.rate_hz = 5.0;
        sensors.lidar.range_max_m = 8.0;
        sim::SimulatedStream stream(room_with_shelf(0.5, -2.0), sensors);
        while (const std::optional<SensorFrame> frame = stream.next()) {
            localizer.update(*frame);
        }
        EXPECT_TRUE(localizer.is_mapping());
        EXPECT_GT(walls_in(localizer.map(), 0.5, -2.0, 0.6), 10U);
        return walls_in(localizer.map(), 3.5, 2.5, 0.6);
    };
    EXPECT_LE(after(5), 1U);
    EXPECT_GT(after(0), after(5) + 2);  // without a half-life this drive is too short to outweigh the first
}

}  // namespace
}  // namespace ddtool::merging

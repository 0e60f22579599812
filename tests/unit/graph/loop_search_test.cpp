#include "graph/loop_search.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "sim/lidar.hpp"
#include "simulated_drive.hpp"

namespace ddtool::graph {
namespace {

using namespace test;

Eigen::Matrix3d gate(double sd_m, double sd_rad) {
    return Eigen::Vector3d(sd_m * sd_m, sd_m * sd_m, sd_rad * sd_rad).asDiagonal();
}

/// The local map of a drive of 2 m in the world from a start, in the frame of its start.
StretchMap local_map(sim::World world, const Pose2& start) {
    const Point2 end = start * Point2{2.0, 0.0};
    world.route = {.start = start, .way_points = {end}};
    const RbpfSettings settings;
    std::vector<Node> nodes;
    std::vector<Pose2> path;
    for (const SensorFrame& frame : simulated_drive(world, 8.0)) {
        nodes.emplace_back();
        nodes.back().points = PackedScan(scan_points(frame, settings.points));
        path.push_back(between(start, *frame.world_from_robot));
    }
    // Simulated worlds begin at the robot's start, so the true poses are already relative to it.
    const Pose2 first = path.front();
    for (Pose2& pose : path) {
        pose = between(first, pose);
    }
    StretchMaps maps(nodes, path, settings);
    return *maps.map_of({.first = 0, .last = nodes.size() - 1, .anchor = 0, .way_m = 0.0});
}

sim::World room() {
    sim::World world{.name = "room", .description = "", .segments = {}, .arcs = {}, .route = {}};
    sim::add_polyline(world, {{-3, -2}, {5, -2}, {5, 1}, {4, 1}, {4, 3}, {-3, 3}, {-3, -2}});
    sim::add_box(world, {1.0, 2.0, 0.3}, 0.8, 0.5);
    return world;
}

sim::World corridor(bool with_recess) {
    sim::World world{.name = "corridor", .description = "", .segments = {}, .arcs = {}, .route = {}};
    sim::add_polyline(world, {{-40, 1}, {40, 1}});
    if (with_recess) {
        sim::add_polyline(world, {{-40, -1}, {1, -1}, {1, -1.5}, {2, -1.5}, {2, -1}, {40, -1}});
    } else {
        sim::add_polyline(world, {{-40, -1}, {40, -1}});
    }
    return world;
}

TEST(LoopSearch, FindsARoomAgainWithinAWideGate) {
    const StretchMap older = local_map(room(), {-1.0, 0.0, 0.0});
    const Pose2 newer_start{0.5, 0.5, 0.6};
    const StretchMap newer = local_map(room(), newer_start);
    const Pose2 truth = between({-1.0, 0.0, 0.0}, newer_start);
    LoopSearch search{RbpfSettings{}};
    const Pose2 predicted{truth.x_m + 1.1, truth.y_m - 0.7, truth.theta_rad + 0.2};
    const LoopMatch match = search.match(older, newer, predicted, gate(0.7, 0.15));
    EXPECT_EQ(match.refusal, "");
    EXPECT_LT(distance_m(match.older_from_newer, truth), 0.03);
    EXPECT_NEAR(match.older_from_newer.theta_rad, truth.theta_rad, 0.01);
    EXPECT_FALSE(match.open_along);
    EXPECT_GT(match.information.eigenvalues().real().minCoeff(), 1e3);
}

TEST(LoopSearch, ABareCorridorHoldsHeadingAndOffsetAlone) {
    const StretchMap older = local_map(corridor(false), {0.0, 0.0, 0.0});
    const StretchMap newer = local_map(corridor(false), {0.6, 0.2, 0.05});
    LoopSearch search{RbpfSettings{}};
    const LoopMatch match = search.match(older, newer, {0.2, 0.0, 0.0}, gate(0.5, 0.05));
    EXPECT_EQ(match.refusal, "");
    EXPECT_NEAR(match.older_from_newer.y_m, 0.2, 0.03);
    EXPECT_NEAR(match.older_from_newer.theta_rad, 0.05, 0.01);
    const double c = std::cos(match.older_from_newer.theta_rad);
    const double s = std::sin(match.older_from_newer.theta_rad);
    const Eigen::Vector3d along(c, -s, 0.0);
    const Eigen::Vector3d across(s, c, 0.0);
    EXPECT_LT(along.dot(match.information * along), 1.0);
    EXPECT_GT(across.dot(match.information * across), 1e3);
    EXPECT_GT(match.information(2, 2), 1e4);
}

TEST(LoopSearch, ARecessHoldsTheWayAlong) {
    const StretchMap older = local_map(corridor(true), {0.0, 0.0, 0.0});
    const StretchMap newer = local_map(corridor(true), {0.6, 0.2, 0.0});
    LoopSearch search{RbpfSettings{}};
    const LoopMatch match = search.match(older, newer, {0.2, 0.0, 0.0}, gate(0.3, 0.05));
    EXPECT_EQ(match.refusal, "");
    EXPECT_NEAR(match.older_from_newer.x_m, 0.6, 0.03);
    EXPECT_GT(match.information(0, 0), 100.0);
}

/// The corridor's end, which few of the points show, lies in sight of both, and the prediction is half a metre off.
TEST(LoopSearch, TheEndOfABareCorridorIsFound) {
    sim::World world = corridor(false);
    sim::add_polyline(world, {{5, -1}, {5, 1}});
    const StretchMap older = local_map(world, {0.0, 0.0, 0.0});
    const StretchMap newer = local_map(world, {0.6, 0.2, 0.0});
    LoopSearch search{RbpfSettings{}};
    const LoopMatch match = search.match(older, newer, {0.1, 0.2, 0.0}, gate(0.3, 0.05));
    EXPECT_EQ(match.refusal, "");
    EXPECT_NEAR(match.older_from_newer.x_m, 0.6, 0.03);
    EXPECT_FALSE(match.open_along);
}

/// Two robots on the two sides of one straight wall: their maps fit, and no ground is free in both.
TEST(LoopSearch, BothSidesOfAWallAreNotOnePlace) {
    sim::World wall{.name = "wall", .description = "", .segments = {}, .arcs = {}, .route = {}};
    sim::add_polyline(wall, {{-40, 0}, {1, 0}, {1.5, 0.2}, {2, 0}, {40, 0}});
    const StretchMap older = local_map(wall, {0.0, 1.0, 0.0});
    const StretchMap newer = local_map(wall, {0.0, -1.0, 0.0});
    LoopSearch search{RbpfSettings{}};
    const LoopMatch match = search.match(older, newer, {0.0, -2.0, 0.0}, gate(0.3, 0.05));
    EXPECT_EQ(match.refusal, "the maps lie on different sides of a wall");
}

TEST(LoopSearch, OtherPlacesAreRefused) {
    const StretchMap older = local_map(room(), {-1.0, 0.0, 0.0});
    const StretchMap newer = local_map(corridor(true), {0.0, 0.0, 0.0});
    LoopSearch search{RbpfSettings{}};
    EXPECT_NE(search.match(older, newer, {}, gate(0.5, 0.1)).refusal, "");
}

TEST(LoopSearch, OverlapCountsPointsOnWalls) {
    const StretchMap map = local_map(room(), {-1.0, 0.0, 0.0});
    const Overlap same = overlap(map, map.grid, {});
    EXPECT_GT(same.agreed_share(), 0.97);
    EXPECT_GT(same.known_share(), 0.97);
    EXPECT_LT(overlap(map, map.grid, {0.7, 0.4, 0.3}).agreed_share(), 0.5);
    EXPECT_LT(overlap(map, map.grid, {30.0, 0.0, 0.0}).known_share(), 0.01);
}

}  // namespace
}  // namespace ddtool::graph

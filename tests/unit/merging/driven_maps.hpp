#pragma once

#include <cmath>
#include <functional>
#include <optional>
#include <string>

#include "maps/saved_map.hpp"
#include "quick_drives.hpp"

namespace ddtool::merging::test {

using ddtool::test::two_rooms;

/// Two rooms with a corridor between them, the same seen from either end.
inline sim::World twin_rooms() {
    sim::World world{.name = "twins", .description = "", .segments = {}, .arcs = {}, .route = {}};
    sim::add_polyline(world, {{-2, -2},
                              {3, -2},
                              {3, -0.8},
                              {11, -0.8},
                              {11, -2.5},
                              {16, -2.5},
                              {16, 2},
                              {11, 2},
                              {11, 0.8},
                              {3, 0.8},
                              {3, 2.5},
                              {-2, 2.5},
                              {-2, -2}});
    world.route = {.start = {}, .way_points = {{2.0, 0.5}, {12.0, 0.0}, {15.0, 1.0}, {12.0, 0.0}, {0.0, 0.0}}};
    return world;
}

/// A hall with pillars, another place than the rooms.
inline sim::World hall() {
    sim::World world{.name = "hall", .description = "", .segments = {}, .arcs = {}, .route = {}};
    sim::add_polyline(world, {{-3, -3}, {9, -3}, {9, 1}, {12, 1}, {12, 6}, {-3, 6}, {-3, -3}});
    sim::add_box(world, {2.0, 2.5, 0.3}, 0.5, 0.5);
    sim::add_box(world, {6.0, -1.5, 0.0}, 0.8, 0.4);
    world.route = {.start = {}, .way_points = {{4.0, 0.0}, {7.0, 3.0}, {0.0, 4.5}, {0.0, 0.0}}};
    return world;
}

/// The map of a drive, its scans at their true poses as seen from `origin`, of those that were taken where `taken`
/// says.
inline maps::SavedMap map_of(const sim::World& world, std::uint64_t seed, const Pose2& origin,
                             const std::function<bool(const Pose2&)>& taken) {
    sim::SimulatedStream stream(world, ddtool::test::quick_sensors(seed));
    maps::SavedMap map{OccupancySettings{}};
    map.program = "test";
    map.drives = {{.log = world.name + std::to_string(seed), .odometry = {}}};
    std::optional<Pose2> last;
    std::size_t number = 0;
    while (const std::optional<SensorFrame> frame = stream.next()) {
        const Pose2& at = *frame->world_from_robot;
        const bool moved =
            !last || distance_m(*last, at) > 0.3 || std::abs(wrap_angle(last->theta_rad - at.theta_rad)) > 0.3;
        if (moved && taken(at)) {
            last = at;
            maps::MapNode node;
            node.scan = {.stamp_ns = frame->scan.stamp_ns,
                         .scan = number,
                         .odom_from_robot = frame->odom_from_robot,
                         .duration_s = 0.3,
                         .degree = 0.0,
                         .points = graph::PackedScan(scan_points(*frame, {}))};
            node.pose = inverse(origin) * at;
            map.nodes.push_back(std::move(node));
        }
        ++number;
    }
    map.grid = maps::drawn(map.nodes, map.grid.settings());
    return map;
}

inline bool anywhere(const Pose2& /*pose*/) { return true; }

}  // namespace ddtool::merging::test

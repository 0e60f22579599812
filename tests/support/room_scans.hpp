#pragma once

#include <numbers>

#include "ddtool/robot/scan_points.hpp"
#include "sim/lidar.hpp"

namespace ddtool {

/// Four walls around the world's origin.
inline sim::World room(double length_m, double width_m) {
    sim::World world;
    sim::add_box(world, {}, length_m, width_m);
    return world;
}

/// A room in which no two views look alike.
inline sim::World furnished_room() {
    sim::World world = room(9.0, 7.0);
    sim::add_box(world, {3.0, 2.0, 0.3}, 1.2, 0.6);
    sim::add_box(world, {-2.5, -2.2, 0.0}, 0.8, 0.8);
    sim::add_box(world, {-3.5, 2.0, 1.0}, 0.5, 1.5);
    return world;
}

/// A scan of a full turn without noise.
inline SensorFrame exact_scan(const sim::World& world, const Pose2& world_from_robot, int beams, double range_max_m) {
    sim::LidarSettings lidar;
    lidar.beams = beams;
    lidar.range_max_m = range_max_m;
    SensorFrame frame{.scan = sim::blank_scan(lidar, 0),
                      .robot_from_laser = {},
                      .odom_from_robot = world_from_robot,
                      .world_from_robot = world_from_robot};
    const sim::BeamHits hits = sim::cast_beams(frame.scan, {world_from_robot}, sim::RayCaster(world));
    for (std::size_t beam = 0; beam < hits.size(); ++beam) {
        if (hits[beam]) {
            frame.scan.ranges_m[beam] = static_cast<float>(hits[beam]->range_m);
        }
    }
    return frame;
}

inline ScanPoints exact_points(const sim::World& world, const Pose2& world_from_robot, int beams = 720,
                               double range_max_m = 30.0) {
    return scan_points(exact_scan(world, world_from_robot, beams, range_max_m), {});
}

}  // namespace ddtool

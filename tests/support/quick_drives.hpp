#pragma once

#include <cstdint>

#include "sim/simulated_stream.hpp"

namespace ddtool::test {

/// Sensors whose drives take little time.
inline sim::SimulationSettings quick_sensors(std::uint64_t seed) {
    sim::SimulationSettings settings;
    settings.seed = seed;
    settings.lidar.beams = 180;
    settings.lidar.rate_hz = 5.0;
    settings.lidar.range_max_m = 8.0;
    return settings;
}

/// Two rooms of different forms, joined by a corridor that has a recess.
inline sim::World two_rooms() {
    sim::World world{.name = "rooms", .description = "", .segments = {}, .arcs = {}, .route = {}};
    sim::add_polyline(world, {{-2, -2},
                              {3, -2},
                              {3, -0.8},
                              {5, -0.8},
                              {5, -1.4},
                              {6.2, -1.4},
                              {6.2, -0.8},
                              {9, -0.8},
                              {9, -3},
                              {14, -3},
                              {14, 3},
                              {11, 3},
                              {11, 2},
                              {9, 2},
                              {9, 0.8},
                              {3, 0.8},
                              {3, 2.5},
                              {-2, 2.5},
                              {-2, -2}});
    sim::add_box(world, {1.0, 1.5, 0.4}, 0.8, 0.5);
    sim::add_box(world, {12.0, -1.5, 0.9}, 0.7, 0.7);
    world.route = {.start = {}, .way_points = {{2.0, 0.0}, {10.0, 0.0}, {12.5, 1.0}, {10.0, 0.0}, {0.0, 0.0}}};
    return world;
}

}  // namespace ddtool::test

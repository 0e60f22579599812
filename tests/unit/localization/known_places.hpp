#pragma once

#include <memory>
#include <vector>

#include "ddtool/filter/rbpf.hpp"
#include "ddtool/filter/scan_insertion.hpp"
#include "sim/simulated_stream.hpp"

namespace ddtool::localization::test {

inline sim::SimulationSettings sensors(std::uint64_t seed) {
    sim::SimulationSettings settings;
    settings.seed = seed;
    settings.lidar.beams = 180;
    settings.lidar.rate_hz = 5.0;
    settings.lidar.range_max_m = 8.0;
    return settings;
}

inline std::vector<SensorFrame> drive(const sim::World& world, std::uint64_t seed) {
    sim::SimulatedStream stream(world, sensors(seed));
    std::vector<SensorFrame> frames;
    while (std::optional<SensorFrame> frame = stream.next()) {
        frames.push_back(std::move(*frame));
    }
    return frames;
}

/// The map that the scans give at their true poses: the map's frame is the world's.
inline std::shared_ptr<const OccupancyGrid> true_map(const std::vector<SensorFrame>& frames) {
    auto grid = std::make_shared<OccupancyGrid>(OccupancySettings{});
    ScanInserter inserter;
    for (const SensorFrame& frame : frames) {
        inserter.insert(*grid, scan_points(frame, {}), *frame.world_from_robot);
    }
    return grid;
}

/// Two rooms of different forms, joined by a corridor.
inline sim::World two_rooms() {
    sim::World world{.name = "rooms", .description = "", .segments = {}, .arcs = {}, .route = {}};
    sim::add_polyline(world, {{-2, -2},
                              {3, -2},
                              {3, -0.8},
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

/// A bare corridor, 1.6 m wide, much longer than the lidar sees, with rooms at its ends.
inline sim::World long_corridor() {
    sim::World world{.name = "corridor", .description = "", .segments = {}, .arcs = {}, .route = {}};
    sim::add_polyline(world, {{-3, -2},
                              {1, -2},
                              {1, -0.8},
                              {40, -0.8},
                              {40, -3},
                              {44, -3},
                              {44, 2},
                              {40, 2},
                              {40, 0.8},
                              {1, 0.8},
                              {1, 1.5},
                              {-3, 1.5},
                              {-3, -2}});
    world.route = {.start = {-1.0, 0.0, 0.0}, .way_points = {{42.0, 0.0}}};
    return world;
}

}  // namespace ddtool::localization::test

#pragma once

#include <memory>
#include <vector>

#include "ddtool/filter/rbpf.hpp"
#include "ddtool/filter/scan_insertion.hpp"
#include "quick_drives.hpp"

namespace ddtool::localization::test {

using ddtool::test::two_rooms;

inline std::vector<SensorFrame> drive(const sim::World& world, std::uint64_t seed) {
    sim::SimulatedStream stream(world, ddtool::test::quick_sensors(seed));
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

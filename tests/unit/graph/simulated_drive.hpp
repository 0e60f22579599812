#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "ddtool/robot/sensor_stream.hpp"
#include "graph/back_end.hpp"
#include "sim/simulated_stream.hpp"

namespace ddtool::graph::test {

inline std::vector<SensorFrame> simulated_drive(const sim::World& world, double range_m, std::uint64_t seed = 1) {
    sim::SimulationSettings settings;
    settings.seed = seed;
    settings.lidar.beams = 360;
    settings.lidar.rate_hz = 4.0;
    settings.lidar.range_max_m = range_m;
    settings.odometry = sim::odometry_preset("poor");
    sim::SimulatedStream stream(world, settings);
    std::vector<SensorFrame> frames;
    while (std::optional<SensorFrame> frame = stream.next()) {
        frames.push_back(std::move(*frame));
    }
    return frames;
}

/// The odometry's path, in place of a filter's result.
inline Trajectory odometry_path(const std::vector<SensorFrame>& frames) {
    Trajectory path;
    for (const SensorFrame& frame : frames) {
        path.push_back({frame.scan.stamp_ns, frame.odom_from_robot});
    }
    return path;
}

/// What the back end makes of the drive when the filter's path is the odometry's.
inline Smoothed smoothed(const std::vector<SensorFrame>& frames) {
    BackEnd back_end{RbpfSettings{}};
    for (const SensorFrame& frame : frames) {
        back_end.add(frame, Update{});
    }
    return back_end.finish(odometry_path(frames));
}

}  // namespace ddtool::graph::test

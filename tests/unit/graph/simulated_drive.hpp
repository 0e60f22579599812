#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "ddtool/robot/sensor_stream.hpp"
#include "graph/back_end.hpp"
#include "graph/node_recorder.hpp"
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

/// A back end that has the nodes of the drive.
inline BackEnd back_end_after(const std::vector<SensorFrame>& frames) {
    BackEnd back_end{RbpfSettings{}};
    NodeRecorder recorder{RbpfSettings{}};
    for (const SensorFrame& frame : frames) {
        if (std::optional<Node> node = recorder.add(frame, Update{})) {
            back_end.add(std::move(*node));
        }
    }
    return back_end;
}

/// What the back end makes of the drive when the filter's path is the odometry's.
inline Smoothed smoothed(const std::vector<SensorFrame>& frames) {
    return back_end_after(frames).finish(odometry_path(frames));
}

}  // namespace ddtool::graph::test

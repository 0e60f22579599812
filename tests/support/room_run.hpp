#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "ddtool/filter/rbpf.hpp"
#include "room_scans.hpp"
#include "sim/simulated_stream.hpp"

namespace ddtool {

/// A drive through the furnished room. The world's origin is at its start. It is simulated once and then kept.
inline const std::vector<SensorFrame>& room_drive() {
    static const std::vector<SensorFrame> frames = [] {
        sim::World world = furnished_room();
        world.route = {.start = {}, .way_points = {{1.5, -1.5}, {2.5, 0.5}, {0.0, 1.5}}};
        sim::SimulationSettings settings;
        settings.lidar.beams = 240;
        settings.lidar.rate_hz = 6.0;
        settings.odometry = sim::odometry_preset("poor");
        sim::SimulatedStream stream(world, settings);
        std::vector<SensorFrame> all;
        while (std::optional<SensorFrame> frame = stream.next()) {
            all.push_back(std::move(*frame));
        }
        return all;
    }();
    return frames;
}

inline RbpfSettings few_particles(std::size_t particles = 5) {
    RbpfSettings settings;
    settings.particles = particles;
    return settings;
}

/// The trajectory of a filter that has processed all frames.
inline Trajectory filtered(const std::vector<SensorFrame>& frames, const RbpfSettings& settings,
                           const FilterStrategies& strategies = {}, std::size_t threads = 1) {
    ThreadPool pool(threads);
    Rbpf filter(settings, pool, strategies);
    for (const SensorFrame& frame : frames) {
        filter.update(frame);
    }
    return filter.trajectory();
}

inline std::vector<Pose2> poses_of(const Trajectory& trajectory) {
    std::vector<Pose2> poses;
    for (const StampedPose& stamped : trajectory) {
        poses.push_back(stamped.pose);
    }
    return poses;
}

inline void expect_finite_pose_for_every_scan(const Trajectory& trajectory, const std::vector<SensorFrame>& frames) {
    ASSERT_EQ(trajectory.size(), frames.size());
    for (std::size_t i = 0; i < frames.size(); ++i) {
        EXPECT_EQ(trajectory[i].stamp_ns, frames[i].scan.stamp_ns);
        const Pose2& pose = trajectory[i].pose;
        EXPECT_TRUE(std::isfinite(pose.x_m) && std::isfinite(pose.y_m) && std::isfinite(pose.theta_rad)) << i;
    }
}

}  // namespace ddtool

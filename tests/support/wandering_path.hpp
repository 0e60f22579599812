#pragma once

#include <cstdint>

#include "ddtool/base/random.hpp"
#include "ddtool/robot/trajectory.hpp"

namespace ddtool {

/// A random walk with turns, with ten poses per second.
inline Trajectory wandering_path(std::size_t poses, std::uint64_t seed) {
    RandomStream random{seed};
    Trajectory path;
    Pose2 pose{3.0, -2.0, 0.5};
    for (std::size_t i = 0; i < poses; ++i) {
        path.push_back({static_cast<std::int64_t>(i) * 100'000'000, pose});
        pose = pose * Pose2{0.1 + 0.02 * random.normal(), 0.0, 0.2 * random.normal()};
    }
    return path;
}

/// The path with a small random error in every pose.
inline Trajectory noisy(Trajectory path, std::uint64_t seed) {
    RandomStream random{seed};
    for (StampedPose& stamped : path) {
        stamped.pose = stamped.pose * Pose2{0.05 * random.normal(), 0.05 * random.normal(), 0.01 * random.normal()};
    }
    return path;
}

/// The path as seen from another frame.
inline Trajectory moved(Trajectory path, const Pose2& motion) {
    for (StampedPose& stamped : path) {
        stamped.pose = motion * stamped.pose;
    }
    return path;
}

}  // namespace ddtool

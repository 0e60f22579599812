#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "ddtool/robot/pose2.hpp"

namespace ddtool {

struct StampedPose {
    std::int64_t stamp_ns = 0;
    Pose2 pose;  ///< world_from_robot
};

/// Poses in the order they were passed. Stamps usually rise, but old logs jitter backwards (Intel: by up to 0.9 s).
using Trajectory = std::vector<StampedPose>;

/// Sum of the distances between neighbours.
double path_length_m(const Trajectory& trajectory);

/// Pose at a time, interpolated between the neighbours of a trajectory sorted by time; none outside of it.
std::optional<Pose2> pose_at(const Trajectory& sorted_by_time, std::int64_t stamp_ns);

}  // namespace ddtool

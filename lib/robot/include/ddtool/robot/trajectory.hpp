#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "ddtool/robot/pose2.hpp"

namespace ddtool {

struct StampedPose {
    std::int64_t stamp_ns = 0;
    Pose2 pose;  ///< world_from_robot
};

/// Poses in the order in which the robot passed them. Stamps usually rise, but in some old logs they step back (in the
/// log Intel by up to 0.9 s).
using Trajectory = std::vector<StampedPose>;

/// Is called with one pose of a trajectory after the other.
using PoseVisitor = std::function<void(const StampedPose&)>;

/// The length of the path in metres: the sum of the distances between consecutive positions.
double path_length_m(const Trajectory& trajectory);

/// The pose at a time, interpolated between the two neighbours in time; nullopt if the time lies outside of the
/// trajectory.
/// \param sorted_by_time a trajectory whose stamps rise
std::optional<Pose2> pose_at(const Trajectory& sorted_by_time, std::int64_t stamp_ns);

}  // namespace ddtool

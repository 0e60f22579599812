#pragma once

#include <cstdint>
#include <vector>

#include "ddtool/robot/pose2.hpp"

namespace ddtool {

struct SnapshotParticle {
    Pose2 pose;                   ///< world_from_robot, after scan matching
    Pose2 matched_motion;         ///< motion since the last update, in the robot's previous frame, after scan matching
    Pose2 predicted_motion;       ///< the same before scan matching, sampled from the odometry's motion
    double log_likelihood = 0.0;  ///< accumulated since the last resampling
    double log_likelihood_increment = 0.0;  ///< from this update alone
    double match_score = 0.0;               ///< mean beam score in 0..1
    double weight = 0.0;                    ///< normalised, sums to one over the swarm
};

/// Everything that the filter passes on for detection and data sets: the swarm after scan matching, before resampling.
struct ParticleSnapshot {
    std::int64_t stamp_ns = 0;
    std::uint64_t update = 0;  ///< number of filter updates before this one
    Pose2 odometry_motion;     ///< noise-free odometry motion since the last update, in the robot's previous frame
    std::vector<SnapshotParticle> particles;
};

}  // namespace ddtool

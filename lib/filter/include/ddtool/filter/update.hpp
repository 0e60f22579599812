#pragma once

#include <Eigen/Core>
#include <cstdint>

#include "ddtool/filter/stage_times.hpp"
#include "ddtool/swarm/degeneracy_detector.hpp"
#include "ddtool/swarm/particle_snapshot.hpp"

namespace ddtool {

/// What one update of the filter saw and did. The first update starts the map: its particles all stand where the
/// odometry does, with equal weights, no motion and degree 0.
struct Update {
    /// The swarm after scan matching, as the detector saw it. `matched.update` counts the updates before this one.
    ParticleSnapshot matched;
    Degeneracy degeneracy;
    /// The same particles after the corrections, before resampling; equal to `matched` where the method has none.
    ParticleSnapshot corrected;
    /// world_from_robot, of the particle with the largest likelihood since the last resampling.
    Pose2 pose;
    /// Of `pose` (x, y, theta in the world; m^2, m rad, rad^2): how uncertain the particle is of its place in its own
    /// map, and how far the particles' poses are apart.
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
    bool resampled = false;
    StageTimes times;  ///< wall time of this update
};

}  // namespace ddtool

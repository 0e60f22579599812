#pragma once

#include <Eigen/Core>
#include <cstdint>

#include "ddtool/filter/stage_times.hpp"
#include "ddtool/swarm/degeneracy_detector.hpp"
#include "ddtool/swarm/particle_snapshot.hpp"

namespace ddtool {

/// What one update of the filter observed and did. The first update starts the map: its particles are all at the
/// odometry's pose, with equal weights, no motion and degree 0.
struct Update {
    /// The swarm after scan matching, as the detector received it. `matched.update` is the number of updates before
    /// this one.
    ParticleSnapshot matched;
    Degeneracy degeneracy;
    /// The same particles after the corrections, before resampling; equal to `matched` where the method has none.
    ParticleSnapshot corrected;
    /// world_from_robot, of the best particle: the one with the largest likelihood since the last resampling, or for
    /// the GmappingFilter since the start.
    Pose2 pose;
    /// Covariance of `pose` (x, y, theta in the world; m^2, m rad, rad^2): the particle's uncertainty in its own map
    /// plus the spread of the particles' poses about it.
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
    bool resampled = false;
    StageTimes times;  ///< wall time of this update
};

}  // namespace ddtool

#pragma once

#include <cmath>
#include <span>

#include "ddtool/swarm/particle_snapshot.hpp"

namespace ddtool {

/// The covariance of a swarm's positions, along its principal axes.
struct SwarmShape {
    double major_variance_m2 = 0.0;
    double minor_variance_m2 = 0.0;
    double major_direction_rad = 0.0;  ///< in the frame of the positions, in (-pi/2, pi/2]

    [[nodiscard]] double major_sd_m() const { return std::sqrt(major_variance_m2); }
    [[nodiscard]] double minor_sd_m() const { return std::sqrt(minor_variance_m2); }
};

/// The weighted covariance: sum of w (p - mean)(p - mean)^T / (1 - sum of w^2), where w are the particles' weights
/// scaled to sum to one. It is unbiased, and zero where one particle has all the weight. `position` chooses the
/// positions: &SnapshotParticle::pose for how far the particles have drifted apart, ::predicted_motion for the
/// uncertainty that the odometry leaves in one step, ::matched_motion for what the scan leaves of it. Positions that
/// are not finite are ignored.
SwarmShape swarm_shape(std::span<const SnapshotParticle> particles, Pose2 SnapshotParticle::*position);

/// The same with equal weights for all particles.
SwarmShape unweighted_swarm_shape(std::span<const SnapshotParticle> particles, Pose2 SnapshotParticle::*position);

}  // namespace ddtool

#pragma once

#include <cmath>
#include <span>

#include "ddtool/swarm/particle_snapshot.hpp"

namespace ddtool {

/// The covariance of a swarm's positions, in its axes.
struct SwarmShape {
    double major_variance_m2 = 0.0;
    double minor_variance_m2 = 0.0;
    double major_direction_rad = 0.0;  ///< in the frame of the positions, in (-pi/2, pi/2]

    [[nodiscard]] double major_sd_m() const { return std::sqrt(major_variance_m2); }
    [[nodiscard]] double minor_sd_m() const { return std::sqrt(minor_variance_m2); }
};

/// Sum of w (p - mean)(p - mean)^T / (1 - sum of w^2), w the particles' weights scaled to sum to one: unbiased, and
/// zero where one particle has all the weight. `position` says which positions: &SnapshotParticle::pose for how far the
/// particles have drifted apart, ::predicted_motion for what odometry leaves open in a step, ::matched_motion for what
/// the scan leaves of it. Positions that are not finite do not count.
SwarmShape swarm_shape(std::span<const SnapshotParticle> particles, Pose2 SnapshotParticle::*position);

/// The same where every particle counts as much as any other.
SwarmShape unweighted_swarm_shape(std::span<const SnapshotParticle> particles, Pose2 SnapshotParticle::*position);

}  // namespace ddtool

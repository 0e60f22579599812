#pragma once

#include <span>

#include "ddtool/swarm/particle_snapshot.hpp"

namespace ddtool {

/// The weighted covariance of a swarm's positions, in its axes.
struct SwarmShape {
    double major_variance_m2 = 0.0;
    double minor_variance_m2 = 0.0;
    double major_direction_rad = 0.0;  ///< in the frame of the positions, in (-pi/2, pi/2]
};

/// Sum of w (p - mean)(p - mean)^T / (1 - sum of w^2), unbiased for normalised weights; zero where one particle has all
/// the weight.
SwarmShape swarm_shape(std::span<const SnapshotParticle> particles, Pose2 SnapshotParticle::*position);

}  // namespace ddtool

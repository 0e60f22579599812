#pragma once

#include <span>

#include "ddtool/swarm/particle_snapshot.hpp"

namespace ddtool {

/// Standard deviations of positions along the axes of their covariance, which are the roots of its eigenvalues.
struct PositionSpread {
    double major_m = 0.0;
    double minor_m = 0.0;
};

/// Of a swarm: &SnapshotParticle::pose for how far the particles have drifted apart, ::predicted_motion for what
/// odometry leaves open in a step, ::matched_motion for what the scan leaves of it. Unbiased; positions that are not
/// finite do not count; 0 for fewer than two.
PositionSpread position_spread(std::span<const SnapshotParticle> particles, Pose2 SnapshotParticle::*position);

/// The same where every particle counts by its normalised weight: sum w (p - mean)(p - mean)^T / (1 - sum w^2).
PositionSpread weighted_position_spread(std::span<const SnapshotParticle> particles, Pose2 SnapshotParticle::*position);

/// position_spread() along the major axis.
double spread_m(std::span<const SnapshotParticle> particles, Pose2 SnapshotParticle::*position);

/// The matched motions' spread over that of the predicted: how much of odometry's uncertainty the scan has left. 0
/// where nothing was predicted to spread.
double step_spread_ratio(std::span<const SnapshotParticle> particles);

}  // namespace ddtool

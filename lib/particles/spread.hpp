#pragma once

#include <span>

#include "particles/particle_snapshot.hpp"

namespace ddtool {

/// Standard deviation, along the major axis, of the positions of a swarm: &SnapshotParticle::pose for how far the
/// particles have drifted apart, ::predicted_motion for what odometry leaves open in a step, ::matched_motion for what
/// the scan leaves of it. Metres; those that are not finite do not count; 0 for fewer than two.
double spread_m(std::span<const SnapshotParticle> particles, Pose2 SnapshotParticle::*position);

}  // namespace ddtool

#pragma once

#include <span>

#include "ddtool/swarm/particle_snapshot.hpp"

namespace ddtool {

// Numbers of a swarm that may tell degeneracy, each worked out here and nowhere else: the filter's detectors
// (swarm_detectors.hpp), the labels of data sets and `ddtool eval` all call these. `position` is as for swarm_shape().

/// Standard deviation of the positions along the major axis of their covariance, every particle counting the same.
double spread_m(std::span<const SnapshotParticle> particles, Pose2 SnapshotParticle::*position);

/// The matched motions' spread over that of the predicted: how much of odometry's uncertainty the scan has left. 0
/// where nothing was predicted to spread.
double step_spread_ratio(std::span<const SnapshotParticle> particles);

/// The larger eigenvalue of the positions' weighted covariance, m^2: the test of Switch-SLAM (Lee et al. 2024) as the
/// paper compares with it, in place of the inverse of the Hessian's smaller one.
double covariance_eigenvalue_m2(std::span<const SnapshotParticle> particles, Pose2 SnapshotParticle::*position);

/// N_eff / N, the effective sample size (weights.hpp) as a share of the particles.
double effective_share(std::span<const SnapshotParticle> particles);

/// Variance of the normalised weights, sum of (w - mean)^2 / (N - 1): what the paper's eq. w_eigen says word by word.
double weight_variance(std::span<const SnapshotParticle> particles);

/// The paper's R (weights.hpp) over one of the particles' weights, such as &SnapshotParticle::log_likelihood.
double dispersion(std::span<const SnapshotParticle> particles, double SnapshotParticle::*weight);

}  // namespace ddtool

#pragma once

#include <span>

#include "ddtool/swarm/particle_snapshot.hpp"

namespace ddtool {

// Measures of a swarm that may indicate degeneracy. Each is computed only here: the filter's detectors
// (swarm_detectors.hpp), the labels of data sets and `ddtool eval` all call these functions. `position` is as for
// swarm_shape().

/// Standard deviation of the positions along the major axis of their covariance, with equal weights for all particles.
double spread_m(std::span<const SnapshotParticle> particles, Pose2 SnapshotParticle::*position);

/// The spread of the matched motions divided by that of the predicted motions: the share of the odometry's uncertainty
/// that the scan has left. It is 0 if the predicted motions have no spread.
double step_spread_ratio(std::span<const SnapshotParticle> particles);

/// The larger eigenvalue of the positions' weighted covariance, in m^2: the test of Switch-SLAM (Lee et al. 2024) in
/// the form that the paper compares with, which takes this value in place of the inverse of the Hessian's smaller
/// eigenvalue.
double covariance_eigenvalue_m2(std::span<const SnapshotParticle> particles, Pose2 SnapshotParticle::*position);

/// N_eff / N, the effective sample size (weights.hpp) as a share of the particles.
double effective_share(std::span<const SnapshotParticle> particles);

/// Variance of the normalised weights, sum of (w - mean)^2 / (N - 1): the paper's eq. w_eigen taken literally. It is 0
/// for fewer than two particles.
double weight_variance(std::span<const SnapshotParticle> particles);

/// The paper's dispersion R (weights.hpp) of the given member of the particles, such as
/// &SnapshotParticle::log_likelihood.
double dispersion(std::span<const SnapshotParticle> particles, double SnapshotParticle::*weight);

}  // namespace ddtool

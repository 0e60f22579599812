#pragma once

#include <memory>

#include "ddtool/swarm/degeneracy_detector.hpp"
#include "ddtool/swarm/motion_model.hpp"

namespace ddtool {

class ScanTruth;

/// The test of Switch-SLAM (Lee et al. 2024, "Switch-SLAM: Switching-based LiDAR-inertial-visual SLAM for degenerate
/// environments") as the paper uses it: the larger eigenvalue lambda of the weighted covariance of the swarm's
/// positions is compared with a threshold, here threshold_sd_m^2. As a degree it is lambda / (lambda + threshold),
/// which is 0.5 at the threshold.
DegeneracyDetector covariance_detector(double threshold_sd_m);

/// The share of the odometry's uncertainty in one step that the match has left: the matched motions' standard deviation
/// over that of the predicted motions, each along its own major axis, at most 1. Where the match has information I_m
/// along that axis and the sampled motion I_s, the ratio is I_s / (I_s + I_m).
DegeneracyDetector step_spread_detector();

/// The degree is 1 - N_eff / N, the share of particles whose weight no longer counts.
DegeneracyDetector effective_size_detector();

/// The degree is 1 for every swarm. It shows what a method does if it always takes the scan to be degenerate.
DegeneracyDetector always_degenerate();

/// Compares the true uncertainty of the scan with that of the odometry, from the simulator's Fisher information: with
/// sd_m and sd_o the standard deviations of the scan and of the odometry along the direction that the scan constrains
/// least, the degree is sd_m^2 / (sd_m^2 + sd_o^2), which is 0.5 where both are equal. `truth` holds what the source of
/// the snapshots reports (SensorStream::tell_truth()). The detector throws Error for a snapshot whose scan is not in
/// `truth`, and if `truth` is null.
DegeneracyDetector oracle_detector(const MotionNoise& noise, std::shared_ptr<const ScanTruth> truth);

}  // namespace ddtool

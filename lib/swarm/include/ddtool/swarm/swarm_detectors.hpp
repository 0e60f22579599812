#pragma once

#include <memory>

#include "ddtool/swarm/degeneracy_detector.hpp"
#include "ddtool/swarm/motion_model.hpp"

namespace ddtool {

class ScanTruth;

/// Switch-SLAM's test (Lee et al. 2024, "Switch-SLAM: Switching-based LiDAR-inertial-visual SLAM for degenerate
/// environments") as the paper uses it: the larger eigenvalue of the swarm's weighted covariance of positions against a
/// threshold. As a degree, lambda / (lambda + threshold): 0.5 at the threshold.
DegeneracyDetector covariance_detector(double threshold_sd_m);

/// How much of the spread that odometry leaves open in a step the match leaves: the ratio of the two step swarms'
/// standard deviations along their major axes, at most 1. Where the match has the information I_m along that axis
/// and the sampled motion I_s, the ratio is I_s / (I_s + I_m).
DegeneracyDetector step_spread_detector();

/// 1 - N_eff / N, the share of particles whose weight no longer counts.
DegeneracyDetector effective_size_detector();

/// Degree 1, whatever the swarm: what a method does where it always takes the scan for degenerate.
DegeneracyDetector always_degenerate();

/// The true scan's say against the odometry's, from the simulator's Fisher information: sd_m^2 / (sd_m^2 + sd_o^2)
/// along the direction that the scan holds least, 0.5 where both say as much. `truth` is what the snapshots' source
/// tells (SensorStream::tell_truth()). The detector throws Error for a snapshot whose scan is not in it.
DegeneracyDetector oracle_detector(const MotionNoise& noise, std::shared_ptr<const ScanTruth> truth);

}  // namespace ddtool

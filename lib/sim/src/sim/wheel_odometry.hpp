#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "ddtool/robot/trajectory.hpp"

namespace ddtool::sim {

/// How wheels and gyro err. A run draws one scale error and one gyro bias and keeps them; noise is a random walk, its
/// variance growing in proportion to the motion, so it does not depend on the odometry's rate.
struct OdometrySettings {
    double rate_hz = 50.0;
    double scale_error_sd = 0.005;  ///< relative error of distances (wheel radius), standard deviation over runs
    double gyro_bias_sd_rad_per_s = 1.5e-4;  ///< error of the turn rate, standard deviation over runs
    double distance_noise_m_per_sqrt_m = 0.01;
    double heading_noise_rad_per_sqrt_m = 1.0e-3;
    double heading_noise_rad_per_sqrt_rad = 4.0e-3;
    double slips_per_m = 0.005;  ///< mean number of slips (a Poisson process along the way)
    double slip_m = 0.02;        ///< mean distance that wheels turn too far in a slip (exponentially distributed)
    double slip_rad = 2.0e-3;    ///< standard deviation of the heading error of a slip
};

/// `good` (calibrated, with a good gyro), `typical`, `poor` (wheels alone on a slippery floor); docs/simulator.md
/// states the drift measured for each. Throws UsageError for another name.
OdometrySettings odometry_preset(const std::string& name);
std::vector<std::string> odometry_preset_names();

/// odom_from_robot at the odometry's rate, the first at the trajectory's first stamp (where it is the zero pose), the
/// last not before its last stamp.
Trajectory simulate_odometry(const Trajectory& truth, const OdometrySettings& settings, std::uint64_t seed);

}  // namespace ddtool::sim

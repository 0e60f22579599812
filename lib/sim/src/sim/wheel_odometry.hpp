#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "ddtool/robot/trajectory.hpp"

namespace ddtool::sim {

/// The errors of wheels and gyro. Each run draws one scale error and one gyro bias, which stay constant. Noise is a
/// random walk whose variance grows in proportion to the motion, so that it does not depend on the rate of the
/// odometry.
struct OdometrySettings {
    double rate_hz = 50.0;
    double scale_error_sd = 0.005;  ///< relative error of distances (wheel radius), standard deviation over runs
    double turn_error = 0.0;        ///< relative error of turns (distance of the wheels), the same in all runs
    double gyro_bias_sd_rad_per_s = 1.5e-4;  ///< error of the turn rate, standard deviation over runs
    double distance_noise_m_per_sqrt_m = 0.01;
    double heading_noise_rad_per_sqrt_m = 1.0e-3;
    double heading_noise_rad_per_sqrt_rad = 4.0e-3;
    double slips_per_m = 0.005;  ///< mean number of slips (a Poisson process along the way)
    double slip_m = 0.02;        ///< mean distance that wheels turn too far in a slip (exponentially distributed)
    double slip_rad = 2.0e-3;    ///< standard deviation of the heading error of a slip
};

/// The preset `good` (calibrated, with a good gyro), `typical` or `poor` (wheels alone on a slippery floor);
/// docs/simulator.md states the drift measured for each. Throws UsageError for any other name.
OdometrySettings odometry_preset(const std::string& name);
std::vector<std::string> odometry_preset_names();

/// The odometry (odom_from_robot) at its own rate. The first pose is at the first stamp of the true trajectory and is
/// the zero pose; the last one is not earlier than the last stamp of the true trajectory.
/// \param truth world_from_robot, with rising stamps
Trajectory simulate_odometry(const Trajectory& truth, const OdometrySettings& settings, std::uint64_t seed);

}  // namespace ddtool::sim

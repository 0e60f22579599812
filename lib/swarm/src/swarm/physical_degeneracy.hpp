#pragma once

#include <Eigen/Core>

#include "ddtool/swarm/motion_model.hpp"

namespace ddtool {

/// How well a scan holds the position, heading unknown (Cramer-Rao): sd along the direction least and best held.
/// Infinite where nothing holds it.
struct PhysicalDegeneracy {
    double weak_sd_m = 0.0;
    double weak_direction_rad = 0.0;  ///< in the robot's frame, in (-pi/2, pi/2]
    double strong_sd_m = 0.0;
    double odometry_sd_m = 0.0;  ///< of the motion model over the step, along the weak direction
};

/// information: of the scan about (x, y, theta) in the robot's frame; odometry: of the step that led to it.
PhysicalDegeneracy physical_degeneracy(const Eigen::Matrix3d& information, const MotionSigmas& odometry);

/// Information of a scan that is matched to a map of cells instead of the true surfaces: these are known to a uniform
/// cell's standard deviation, which adds to the beam's.
Eigen::Matrix3d information_on_map(const Eigen::Matrix3d& information, double range_sd_m, double cell_size_m);

}  // namespace ddtool

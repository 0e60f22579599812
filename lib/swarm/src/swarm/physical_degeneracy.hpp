#pragma once

#include <Eigen/Core>

#include "ddtool/swarm/motion_model.hpp"

namespace ddtool {

/// How well a scan determines the position while the heading is unknown too (Cramer-Rao bound): the standard deviations
/// along the least and the best constrained direction. They are infinite along a direction that the scan does not
/// constrain.
struct PhysicalDegeneracy {
    double weak_sd_m = 0.0;
    double weak_direction_rad = 0.0;  ///< in the robot's frame, in (-pi/2, pi/2]
    double strong_sd_m = 0.0;
    double odometry_sd_m = 0.0;  ///< of the odometry's motion in this step, along the weak direction
};

/// information: that of the scan about (x, y, theta) in the robot's frame (1/m^2, 1/(m rad), 1/rad^2). odometry:
/// deviations of the step that led to the scan, in the robot's frame.
PhysicalDegeneracy physical_degeneracy(const Eigen::Matrix3d& information, const MotionSigmas& odometry);

/// Scales the information of a scan, which assumes exactly known surfaces, to a scan that is matched to a map of cells.
/// A surface in such a map is known to the variance of a uniform distribution over a cell, cell_size_m^2 / 12, which
/// adds to the variance of the beam's range.
Eigen::Matrix3d information_on_map(const Eigen::Matrix3d& information, double range_sd_m, double cell_size_m);

}  // namespace ddtool

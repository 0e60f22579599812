#pragma once

#include <Eigen/Core>

#include "sim/lidar.hpp"

namespace ddtool::sim {

/// Fisher information of a scan about the robot's pose: 3 x 3 over (x, y, theta) in the robot's frame, in 1/m^2, 1/m
/// and 1. Its inverse, if it exists, is the smallest covariance that any scan matching with the true map can reach
/// (Censi 2007, "On achievable accuracy for range-finder localization", eq. 3; Cramer-Rao).
///
/// A beam from p along u (robot's frame) that meets a surface of normal n at h = p + r u has
///     dr / d(x, y, theta) = -(n_x, n_y, n . J h) / (n . u),   J = rotation by 90 degrees,
/// and adds its outer product times (1 - drop-out probability) / sd(r)^2. Beams without return add nothing.
/// `hits` are of `scan` taken at world_from_robot; edges count as the surface they are on.
Eigen::Matrix3d fisher_information(const LaserScan& scan, const BeamHits& hits, const Pose2& world_from_robot,
                                   const Pose2& robot_from_laser, const LidarSettings& settings);

}  // namespace ddtool::sim

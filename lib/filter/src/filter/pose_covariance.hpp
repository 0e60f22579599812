#pragma once

#include <Eigen/Core>

#include "ddtool/robot/pose2.hpp"
#include "ddtool/swarm/motion_model.hpp"
#include "ddtool/swarm/particle_snapshot.hpp"

namespace ddtool {

/// The rotation by theta_rad of vectors (x, y, theta): a covariance C in the robot's frame is R C R' in the world's, an
/// information matrix likewise, where theta_rad is the robot's heading.
Eigen::Matrix3d turned_about_z(double theta_rad);

/// Covariance (x, y, theta in the world frame) of `from * motion`, where `covariance` is that of `from` and `sigmas`
/// are those of the motion in the frame of `from`: first order, F P F' + G Q G'.
Eigen::Matrix3d predicted_covariance(const Eigen::Matrix3d& covariance, const Pose2& from, const Pose2& motion,
                                     const MotionSigmas& sigmas);

/// Covariance after a measurement of that information: (P^-1 + I)^-1, also where I is singular.
Eigen::Matrix3d corrected_covariance(const Eigen::Matrix3d& covariance, const Eigen::Matrix3d& information);

/// Weighted covariance (x, y, theta in the world) of a swarm's poses about `centre`, headings as wrapped differences.
Eigen::Matrix3d pose_scatter(const ParticleSnapshot& swarm, const Pose2& centre);

}  // namespace ddtool

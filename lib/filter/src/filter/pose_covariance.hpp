#pragma once

#include <Eigen/Core>

#include "ddtool/robot/pose2.hpp"
#include "ddtool/swarm/motion_model.hpp"

namespace ddtool {

/// The rotation R by theta_rad of vectors (x, y, theta). Where theta_rad is the robot's heading, a covariance C in the
/// robot's frame is R C R' in the world frame; the same holds for an information matrix.
Eigen::Matrix3d turned_about_z(double theta_rad);

/// The differences of x, y and theta, in the frame that both poses are in.
Eigen::Vector3d offset(const Pose2& from, const Pose2& to);

/// The pose at that offset.
Pose2 moved_by(const Pose2& pose, const Eigen::Vector3d& by);

/// Covariance (x, y, theta in the world frame) of `from * motion`, to first order: F P F' + G Q G'. `covariance` is
/// that of `from`; `sigmas` are those of the motion, in the frame of `from`.
Eigen::Matrix3d predicted_covariance(const Eigen::Matrix3d& covariance, const Pose2& from, const Pose2& motion,
                                     const MotionSigmas& sigmas);

/// Covariance after a measurement with the given information I: (P^-1 + I)^-1. I may be singular.
Eigen::Matrix3d corrected_covariance(const Eigen::Matrix3d& covariance, const Eigen::Matrix3d& information);

}  // namespace ddtool

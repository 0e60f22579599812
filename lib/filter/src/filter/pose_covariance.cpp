#include "filter/pose_covariance.hpp"

#include <Eigen/LU>
#include <cmath>

namespace ddtool {
namespace {

Eigen::Matrix3d symmetric(const Eigen::Matrix3d& matrix) { return 0.5 * (matrix + matrix.transpose()); }

/// Variances that every motion has at least, (0.5 mm)^2 and (0.2 mrad)^2: no odometry is better, and the covariance
/// stays invertible.
const Eigen::Vector3d least_noise(2.5e-7, 2.5e-7, 4e-8);

}  // namespace

Eigen::Vector3d offset(const Pose2& from, const Pose2& to) {
    return {to.x_m - from.x_m, to.y_m - from.y_m, wrap_angle(to.theta_rad - from.theta_rad)};
}

Pose2 moved_by(const Pose2& pose, const Eigen::Vector3d& by) {
    return {pose.x_m + by.x(), pose.y_m + by.y(), wrap_angle(pose.theta_rad + by.z())};
}

Eigen::Matrix3d turned_about_z(double theta_rad) {
    const double c = std::cos(theta_rad);
    const double s = std::sin(theta_rad);
    Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
    rotation.topLeftCorner<2, 2>() << c, -s, s, c;
    return rotation;
}

Eigen::Matrix3d predicted_covariance(const Eigen::Matrix3d& covariance, const Pose2& from, const Pose2& motion,
                                     const MotionSigmas& sigmas) {
    const double c = std::cos(from.theta_rad);
    const double s = std::sin(from.theta_rad);
    const Eigen::Matrix3d to_world = turned_about_z(from.theta_rad);
    Eigen::Matrix3d carried = Eigen::Matrix3d::Identity();
    carried(0, 2) = -s * motion.x_m - c * motion.y_m;
    carried(1, 2) = c * motion.x_m - s * motion.y_m;
    const Eigen::Vector3d noise = Eigen::Vector3d(sigmas.x_m, sigmas.y_m, sigmas.theta_rad).cwiseAbs2() + least_noise;
    return symmetric(carried * covariance * carried.transpose() + to_world * noise.asDiagonal() * to_world.transpose());
}

Eigen::Matrix3d corrected_covariance(const Eigen::Matrix3d& covariance, const Eigen::Matrix3d& information) {
    return symmetric(covariance * (Eigen::Matrix3d::Identity() + information * covariance).inverse());
}

}  // namespace ddtool

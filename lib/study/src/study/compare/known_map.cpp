#include "study/compare/known_map.hpp"

#include <Eigen/Dense>
#include <cmath>
#include <utility>

#include "base/squared.hpp"
#include "ddtool/base/error.hpp"
#include "filter/pose_covariance.hpp"

namespace ddtool::compare {
namespace {

constexpr std::uint64_t measurement_draw = 31;

/// Keeps the covariances invertible while the robot does not move. In m^2 and rad^2; its root, 1e-5, is far below any
/// error that matters here.
constexpr double least_variance = 1e-10;

Eigen::Vector3d vector_of(const Pose2& pose) { return {pose.x_m, pose.y_m, pose.theta_rad}; }

/// The variance that the odometry adds along the motion, across it, and to the heading. The lengths of the slips are
/// distributed exponentially, so the mean of their squares is twice the square of their mean.
Eigen::Vector3d noise_of(const sim::OdometrySettings& odometry, const Pose2& motion) {
    const double way_m = std::hypot(motion.x_m, motion.y_m);
    const double along =
        squared(odometry.distance_noise_m_per_sqrt_m) + 2.0 * odometry.slips_per_m * squared(odometry.slip_m);
    const double turn =
        squared(odometry.heading_noise_rad_per_sqrt_m) + odometry.slips_per_m * squared(odometry.slip_rad);
    return {
        along * way_m + least_variance, least_variance,
        turn * way_m + squared(odometry.heading_noise_rad_per_sqrt_rad) * std::abs(motion.theta_rad) + least_variance};
}

}  // namespace

KnownMapEstimator::KnownMapEstimator(const sim::OdometrySettings& odometry, std::uint64_t seed,
                                     std::shared_ptr<const ScanTruth> truth)
    : odometry_(odometry), random_({seed, measurement_draw}), truth_(std::move(truth)) {}

void KnownMapEstimator::process(const SensorFrame& frame) {
    const auto information = truth_->fisher_information(frame.scan.stamp_ns);
    if (!frame.world_from_robot || !information) {
        throw Error(
            "kind known-map: expected a simulated world, which has the truth and the scans' Fisher information");
    }
    Step step;
    step.stamp_ns = frame.scan.stamp_ns;
    if (steps_.empty()) {
        step.predicted << vector_of(*frame.world_from_robot), 1.0, 0.0;
        step.predicted_covariance = Matrix5::Identity() * least_variance;
        step.predicted_covariance(3, 3) =
            squared(odometry_.scale_error_sd) + squared(odometry_.slips_per_m * odometry_.slip_m);
        step.predicted_covariance(4, 4) = squared(odometry_.gyro_bias_sd_rad_per_s) + squared(least_variance);
        step.transition = Matrix5::Identity();
    } else {
        const double duration_s = 1e-9 * static_cast<double>(step.stamp_ns - steps_.back().stamp_ns);
        predict(between(odom_from_robot_, frame.odom_from_robot), duration_s, step);
    }
    correct(*frame.world_from_robot, *information, step);
    odom_from_robot_ = frame.odom_from_robot;
    steps_.push_back(step);
}

void KnownMapEstimator::predict(const Pose2& motion, double duration_s, Step& step) const {
    const Step& before = steps_.back();
    const Eigen::Matrix3d world_from_robot = turned_about_z(before.filtered(2));
    const Eigen::Vector3d way = world_from_robot * Eigen::Vector3d(motion.x_m, motion.y_m, 0.0);
    const double scale = before.filtered(3);
    step.predicted = before.filtered;
    step.predicted.head<3>() += scale * way;
    step.predicted(2) += motion.theta_rad + before.filtered(4) * duration_s;
    step.transition = Matrix5::Identity();
    step.transition.block<2, 1>(0, 2) << -scale * way.y(), scale * way.x();
    step.transition.block<2, 1>(0, 3) = way.head<2>();
    step.transition(2, 4) = duration_s;
    step.predicted_covariance = step.transition * before.covariance * step.transition.transpose();
    step.predicted_covariance.topLeftCorner<3, 3>() +=
        world_from_robot * noise_of(odometry_, motion).asDiagonal() * world_from_robot.transpose();
}

void KnownMapEstimator::correct(const Pose2& true_pose, const Eigen::Matrix3d& information_in_robot, Step& step) {
    const Eigen::Matrix3d world_from_robot = turned_about_z(true_pose.theta_rad);
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(world_from_robot * information_in_robot *
                                                              world_from_robot.transpose());
    const Eigen::Vector3d values = axes.eigenvalues().cwiseMax(0.0);
    const Eigen::Matrix3d information = axes.eigenvectors() * values.asDiagonal() * axes.eigenvectors().transpose();
    const Eigen::Vector3d normals(random_.normal(), random_.normal(), random_.normal());
    Eigen::Vector3d apart = vector_of(true_pose) - step.predicted.head<3>();
    apart.z() = wrap_angle(apart.z());
    Matrix5 sum = step.predicted_covariance.inverse();
    sum.topLeftCorner<3, 3>() += information;
    step.covariance = sum.inverse();
    // The information matrix times the measurement's difference from the prediction. In this form no measurement is
    // needed along directions about which the scan contains no information.
    const Eigen::Vector3d pull = information * apart + axes.eigenvectors() * values.cwiseSqrt().cwiseProduct(normals);
    step.filtered = step.predicted + step.covariance.leftCols<3>() * pull;
}

Trajectory KnownMapEstimator::trajectory() {
    Trajectory trajectory(steps_.size());
    Vector5 smoothed = Vector5::Zero();
    for (std::size_t i = steps_.size(); i-- > 0;) {
        if (i + 1 == steps_.size()) {
            smoothed = steps_[i].filtered;
        } else {
            const Step& next = steps_[i + 1];
            const Vector5 change = next.predicted_covariance.ldlt().solve(smoothed - next.predicted);
            smoothed = steps_[i].filtered + steps_[i].covariance * next.transition.transpose() * change;
        }
        trajectory[i] = {steps_[i].stamp_ns, {smoothed(0), smoothed(1), wrap_angle(smoothed(2))}};
    }
    return trajectory;
}

}  // namespace ddtool::compare

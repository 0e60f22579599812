#include "ddtool/filter/information_fusion.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace ddtool {
namespace {

Eigen::Vector3d offset(const Pose2& from, const Pose2& to) {
    return {to.x_m - from.x_m, to.y_m - from.y_m, wrap_angle(to.theta_rad - from.theta_rad)};
}

Pose2 moved_by(const Pose2& pose, const Eigen::Vector3d& by) {
    return {pose.x_m + by.x(), pose.y_m + by.y(), wrap_angle(pose.theta_rad + by.z())};
}

/// The offset from the odometry's pose to the pose m that the scan alone would give, to first order. At the matcher's
/// result `found`, the scan with the information I_m and the prior about the sampled pose with the information I_s
/// balance:
///     I_m (m - found) = I_s (found - sampled).
Eigen::Vector3d match_offset(const MatchContext& context, const ScanMatch& found) {
    const Eigen::Matrix3d pull = information_of(context.prior, context.predicted.theta_rad);
    const Eigen::Vector3d from_sample = offset(context.predicted, found.pose);
    constexpr double regularisation = 1e-3;  // keeps the system regular where the scan does not constrain the pose
    const Eigen::Matrix3d system = found.information + regularisation * pull;
    return offset(context.odometry, found.pose) + system.ldlt().solve(pull * from_sample);
}

/// The odometry's information, reduced where odometry and match contradict each other, for example after a slip or a
/// bump, or if the odometry is badly calibrated. The measure is the squared Mahalanobis distance
///     d' (M^-1 + O^-1)^-1 d,
/// where d is the difference of the two poses, and M and O are the information of the match and of the odometry.
Eigen::Matrix3d cautious(const Eigen::Matrix3d& odometry, const Eigen::Matrix3d& match, const Eigen::Vector3d& apart,
                         double most_deviations) {
    const double contradiction = apart.dot(match * (match + odometry).ldlt().solve(odometry * apart));
    return odometry / std::max(1.0, contradiction / (most_deviations * most_deviations));
}

}  // namespace

Eigen::Matrix3d credible_information(const Eigen::Matrix3d& match_information,
                                     const Eigen::Matrix3d& odometry_information, double normal_error_rad,
                                     double degree) {
    const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::Matrix3d> axes(match_information, odometry_information);
    const double floor = normal_error_rad * normal_error_rad * match_information.topLeftCorner<2, 2>().trace();
    const Eigen::Matrix3d& directions = axes.eigenvectors();
    Eigen::Vector3d ratios;
    for (Eigen::Index i = 0; i < 3; ++i) {
        const double lambda = std::max(0.0, axes.eigenvalues()(i) - floor * directions.col(i).head<2>().squaredNorm());
        ratios(i) = lambda * (1.0 - degree / (1.0 + lambda));
    }
    const Eigen::Matrix3d basis = odometry_information * directions;
    return basis * ratios.asDiagonal() * basis.transpose();
}

ScanMatch InformationFusion::correct(const MatchContext& context, const ScanMatch& found) const {
    const bool matched = found.accepted();
    if (matched && context.degeneracy.degree < settings_.least_degree) {
        return found;
    }
    Eigen::Matrix3d match = Eigen::Matrix3d::Zero();
    Eigen::Vector3d apart = Eigen::Vector3d::Zero();
    Eigen::Matrix3d odometry = context.odometry_information;
    if (matched) {
        match = credible_information(found.information, odometry, normal_error_rad, context.degeneracy.degree);
        apart = match_offset(context, found);
        odometry = cautious(odometry, match, apart, settings_.most_deviations);
    }
    const Pose2 pose = moved_by(context.odometry, (match + odometry).ldlt().solve(match * apart));
    ScanMatch fused = found;
    const Eigen::Vector3d change = offset(found.pose, pose);
    if (change.head<2>().norm() > settings_.settled_m || std::abs(change.z()) > settings_.settled_rad) {
        fused = context.matcher.evaluate(context.grid, context.points, pose);
    }
    fused.pose = pose;
    fused.information = match;
    return fused;
}

}  // namespace ddtool

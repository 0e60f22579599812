#include "ddtool/filter/information_fusion.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "filter/pose_covariance.hpp"

namespace ddtool {
namespace {

/// The odometry's information, reduced where odometry and match contradict each other, for example after a slip or a
/// bump, or if the odometry is badly calibrated.
Eigen::Matrix3d cautious(const Eigen::Matrix3d& odometry, const Eigen::Matrix3d& match, const Eigen::Vector3d& apart,
                         double most_deviations) {
    return odometry / std::max(1.0, contradiction(match, odometry, apart) / (most_deviations * most_deviations));
}

}  // namespace

Eigen::Vector3d offset_without_prior(const ScanMatch& found, const Pose2& start, const PosePrior& prior) {
    const Eigen::Matrix3d pull = information_of(prior, start.theta_rad);
    constexpr double regularisation = 1e-3;  // keeps the system regular where the scan does not constrain the pose
    const Eigen::Matrix3d system = found.information + regularisation * pull;
    return system.ldlt().solve(pull * offset(start, found.pose));
}

double contradiction(const Eigen::Matrix3d& match_information, const Eigen::Matrix3d& odometry_information,
                     const Eigen::Vector3d& apart) {
    const Eigen::Matrix3d both = match_information + odometry_information;
    return apart.dot(match_information * both.ldlt().solve(odometry_information * apart));
}

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
    Eigen::Matrix3d odometry = context.pose_information.value_or(context.odometry_information);
    if (matched) {
        // Even in a known map the match is judged against the last motion: what hardly holds the robot beside it is as
        // little to be believed where nothing has held the robot for long.
        match = context.alike != nullptr
                    ? context.alike->information
                    : credible_information(context.information_factor * found.information, context.odometry_information,
                                           normal_error_rad, context.degeneracy.degree);
        apart = offset(context.odometry, found.pose) + offset_without_prior(found, context.predicted, context.prior);
        odometry = cautious(odometry, match, apart, settings_.most_deviations);
    }
    const Pose2 pose = moved_by(context.odometry, (match + odometry).ldlt().solve(match * apart));
    const auto is_settled = [&](const ScanMatch& evaluated) {
        const Eigen::Vector3d change = offset(evaluated.pose, pose);
        return change.head<2>().norm() <= settings_.settled_m && std::abs(change.z()) <= settings_.settled_rad;
    };
    ScanMatch fused = found;
    if (context.alike != nullptr && is_settled(*context.alike)) {
        fused = *context.alike;
    } else if (!is_settled(found)) {
        fused = context.matcher.evaluate(context.grid, context.points, pose);
    }
    fused.pose = pose;
    fused.information = match;
    return fused;
}

}  // namespace ddtool

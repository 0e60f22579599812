#pragma once

#include "ddtool/filter/strategies.hpp"

namespace ddtool {

struct FusionSettings {
    /// Below this degree of degeneracy, an accepted match is used unchanged. 0: every match is weighed against the
    /// odometry, since one that contradicts a good odometry need not come where the detector sees it.
    double least_degree = 0.0;
    /// Where the odometry's pose is farther from the match than this many standard deviations of both together, the
    /// odometry's information is scaled down.
    double most_deviations = 3.0;
    /// If the fusion moves the pose by no more than settled_m and settled_rad, the match's score and likelihood are
    /// kept instead of being computed again at the new pose.
    double settled_m = 0.01;
    double settled_rad = 0.003;
};

/// The part of the match's information about the pose that can be believed. It leaves out what only comes from errors
/// of the surface normals and, in directions in which the match has less information than the odometry, the share
/// `degree` of the rest. The computation is done in the generalised eigenbasis of (match, odometry), where lambda_i is
/// the ratio of their information along direction i (soft solution remapping; compare Zhang, Kaess, Singh, "On
/// degeneracy of optimization-based state estimation problems", ICRA 2016):
///     lambda_i' = max(0, lambda_i - floor_i) (1 - degree / (1 + lambda_i))
/// where the lambda_i in the last factor is the one after floor_i is taken off. Both matrices are over (x, y, theta) in
/// the same frame; odometry_information must be positive definite.
Eigen::Matrix3d credible_information(const Eigen::Matrix3d& match_information,
                                     const Eigen::Matrix3d& odometry_information, double normal_error_rad,
                                     double degree);

/// The offset from the matcher's result `found` to the pose m that the scan alone would give, to first order. At
/// `found`, the scan with the information I_m and the prior about `start` with the information I_s balance:
///     I_m (m - found) = I_s (found - start).
Eigen::Vector3d offset_without_prior(const ScanMatch& found, const Pose2& start, const PosePrior& prior);

/// How far match and odometry contradict each other: the squared Mahalanobis distance
///     d' (M^-1 + O^-1)^-1 d,
/// where d is the difference of the two poses, and M and O are the information of the match and of the odometry, of
/// which M may be singular. All are over (x, y, theta) in the same frame.
double contradiction(const Eigen::Matrix3d& match_information, const Eigen::Matrix3d& odometry_information,
                     const Eigen::Vector3d& apart);

/// The mean of match and odometry, in every direction weighted with the information of each: along a corridor the
/// odometry determines the pose, across it and in heading the walls do. The pose is
///     x = o + (I_m + I_o)^-1 I_m (m - o),
/// where o is the odometry's pose, m the pose that the scan alone would give, to first order (the match without the
/// pull of the sampled motion), and I_m and I_o their information. The result's information is credible_information();
/// it is zero where the match was not accepted.
class InformationFusion : public PoseCorrection {
public:
    /// Standard deviation of the surface normals that the match uses. Because of these errors, a bare wall seems to
    /// constrain the robot a little along itself: by the share normal_error_rad^2 of the information across it. That
    /// amount is subtracted in every direction. It is not a setting because it follows from how ScanPoints computes its
    /// normals.
    static constexpr double normal_error_rad = 0.05;

    explicit InformationFusion(const FusionSettings& settings) : settings_(settings) {}
    ScanMatch correct(const MatchContext& context, const ScanMatch& found) const override;

private:
    FusionSettings settings_;
};

}  // namespace ddtool

#pragma once

#include "ddtool/filter/strategies.hpp"

namespace ddtool {

struct FusionSettings {
    /// Below this degree the match stands as it is.
    double least_degree = 0.25;
    /// Odometry that is farther from the match than this many standard deviations of both counts as less sure.
    double most_deviations = 3.0;
    /// Moved by less, the scan is not judged anew.
    double settled_m = 0.01;
    double settled_rad = 0.003;
};

/// The match's information about the pose without what comes from the normals' errors and, in the directions in which
/// the match says less than the odometry, without the share `degree` of it. In the generalised eigenbasis of (match,
/// odometry), where lambda_i is the ratio of their information along direction i (soft solution remapping; compare
/// Zhang, Kaess, Singh, "On degeneracy of optimization-based state estimation problems", ICRA 2016):
///     lambda_i' = max(0, lambda_i - floor_i) (1 - degree / (1 + lambda_i))
/// Both matrices over (x, y, theta); odometry_information is positive definite.
Eigen::Matrix3d credible_information(const Eigen::Matrix3d& match_information,
                                     const Eigen::Matrix3d& odometry_information, double normal_error_rad,
                                     double degree);

/// The mean of match and odometry, each weighted with its information in every direction: along a corridor the odometry
/// carries the pose, across it and in heading the walls do. The pose is
///     x = o + (I_m + I_o)^-1 I_m (m - o),
/// m the match without the pull of the sampled motion, to first order. The result's information is the credible one.
class InformationFusion : public PoseCorrection {
public:
    /// Error of the surface normals that the match sees. Because of it a bare wall seems to hold the robot a little
    /// along itself: the share normal_error_rad^2 of what it holds across, which is taken off in every direction. No
    /// setting: it is the size that ScanPoints' normals err by, and follows from how they are made.
    static constexpr double normal_error_rad = 0.05;

    explicit InformationFusion(const FusionSettings& settings) : settings_(settings) {}
    ScanMatch correct(const MatchContext& context, const ScanMatch& found) const override;

private:
    FusionSettings settings_;
};

}  // namespace ddtool

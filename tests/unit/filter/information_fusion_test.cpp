#include "ddtool/filter/information_fusion.hpp"

#include <gtest/gtest.h>

#include "known_view.hpp"

namespace ddtool {
namespace {

using Diagonal = Eigen::Vector3d;

Eigen::Matrix3d diagonal(double x, double y, double theta) { return Diagonal(x, y, theta).asDiagonal(); }

TEST(CredibleInformation, IsAllOfAGoodMatch) {
    const Eigen::Matrix3d match = diagonal(4e4, 5e4, 1e6);
    EXPECT_TRUE(credible_information(match, diagonal(1e3, 1e3, 1e4), 0.0, 0.0).isApprox(match, 1e-9));
}

TEST(CredibleInformation, WithoutAWallAheadIsNothingAlongTheWalls) {
    const double across = 1e5;
    const double from_normals = 0.05 * 0.05 * across;
    const Eigen::Matrix3d credible =
        credible_information(diagonal(0.9 * from_normals, across, 1e6), diagonal(1e4, 1e4, 1e5), 0.05, 0.0);
    EXPECT_NEAR(credible(0, 0), 0.0, 1e-6);
    EXPECT_NEAR(credible(1, 1), across, 0.01 * across);
}

TEST(CredibleInformation, LosesTheWeakDirectionAsTheDegreeGrows) {
    const Eigen::Matrix3d match = diagonal(10.0, 1e6, 1e8);
    const Eigen::Matrix3d odometry = diagonal(1e4, 1e4, 1e5);
    const auto along = [&](double degree) { return credible_information(match, odometry, 0.0, degree)(0, 0); };
    EXPECT_NEAR(along(0.5), 0.5 * along(0.0), 0.01 * along(0.0));
    EXPECT_NEAR(along(1.0), 0.0, 0.02);
    EXPECT_GT(credible_information(match, odometry, 0.0, 1.0)(1, 1), 0.98e6);
}

TEST(CredibleInformation, DoesNotDependOnTheAxes) {
    Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
    turn.topLeftCorner<2, 2>() << 0.6, -0.8, 0.8, 0.6;
    const Eigen::Matrix3d match = diagonal(50.0, 1e5, 1e6);
    const Eigen::Matrix3d odometry = diagonal(1e4, 2e4, 1e5);
    const Eigen::Matrix3d turned =
        credible_information(turn * match * turn.transpose(), turn * odometry * turn.transpose(), 0.01, 0.7);
    EXPECT_TRUE(turned.isApprox(turn * credible_information(match, odometry, 0.01, 0.7) * turn.transpose(), 1e-9));
}

/// Along the corridor the result follows the odometry; across it and in heading it follows the walls.
TEST(InformationFusion, TakesTheWayFromOdometryAndTheRestFromTheWalls) {
    KnownView view(long_corridor(), 8.0);
    const Pose2 odometry = view.pose * Pose2{0.02, 0.005, 0.001};
    const Pose2 sampled = view.pose * Pose2{-0.05, 0.03, 0.01};
    MatchContext context = view.context(sampled, odometry, 0.01, 0.005);
    context.degeneracy.degree = 1.0;
    const ScanMatch fused = InformationFusion({}).correct(context, view.match_from(sampled));
    EXPECT_NEAR(fused.pose.x_m, odometry.x_m, 0.002);
    EXPECT_NEAR(fused.pose.y_m, view.pose.y_m, 0.002);
    EXPECT_NEAR(fused.pose.theta_rad, view.pose.theta_rad, 0.001);
}

TEST(InformationFusion, LeavesTheMatchOfARoom) {
    KnownView view(furnished_room());
    const Pose2 odometry = view.pose * Pose2{0.02, 0.01, 0.005};
    const ScanMatch match = view.match_from(odometry);
    for (const double degree : {0.0, 1.0}) {
        const Pose2 fused =
            InformationFusion({}).correct(view.context_of_degree(degree, odometry, 0.03, 0.02), match).pose;
        EXPECT_LT(distance_m(fused, match.pose), 0.003) << degree;
    }
}

/// A quieter lidar holds the robot more firmly against the same odometry.
TEST(InformationFusion, BelievesAMatchByTheNoiseOfItsBeams) {
    KnownView view(furnished_room());
    const Pose2 odometry = view.pose * Pose2{0.004, 0.003, 0.0};
    const ScanMatch match = view.match_from(view.pose);
    const auto from_match_m = [&](double factor) {
        MatchContext context = view.context(view.pose, odometry, 0.004, 0.002);
        context.information_factor = factor;
        return distance_m(InformationFusion({}).correct(context, match).pose, match.pose);
    };
    EXPECT_LT(from_match_m(5.0), 0.5 * from_match_m(1.0));
}

/// A particle that has taken over a match believes as much of it as the one that made it, and is judged by the same
/// look at the map where both come to the same place.
TEST(InformationFusion, TakesOverWhatWasWorkedOutForAMatch) {
    KnownView view(furnished_room());
    const Pose2 odometry = view.pose * Pose2{0.004, 0.003, 0.0};
    const ScanMatch match = view.match_from(view.pose);
    MatchContext context = view.context(view.pose, odometry, 0.004, 0.002);
    const InformationFusion fusion({});
    ScanMatch other = fusion.correct(context, match);
    other.log_likelihood = -1234.0;
    context.alike = &other;
    const ScanMatch near = fusion.correct(context, match);
    EXPECT_EQ(near.pose, other.pose);
    EXPECT_EQ(near.information, other.information);
    EXPECT_EQ(near.log_likelihood, -1234.0);

    other.information *= 1e-3;
    context.odometry = view.pose * Pose2{0.1, 0.0, 0.0};
    context.odometry_information *= 1e3;
    const ScanMatch far = fusion.correct(context, match);
    EXPECT_LT(distance_m(far.pose, context.odometry), 0.02);
    EXPECT_EQ(far.log_likelihood, view.matcher.evaluate(view.grid, view.match_points, far.pose).log_likelihood);
}

TEST(InformationFusion, WithoutAMatchFollowsTheOdometry) {
    KnownView view(furnished_room());
    const Pose2 odometry{50.0, 50.0, 1.0};  // far away from the mapped area
    const ScanMatch nothing = view.matcher.evaluate(view.grid, view.match_points, odometry * Pose2{0.1, 0.1, 0.1});
    const ScanMatch fused = InformationFusion({}).correct(view.context(nothing.pose, odometry), nothing);
    EXPECT_EQ(fused.pose, odometry);
}

/// The wheels have slipped. The surrounding walls determine where the robot is, so the fusion must follow them although
/// the odometry claims a small error.
TEST(InformationFusion, DoubtsOdometryThatTheScanContradicts) {
    KnownView view(furnished_room());
    const Pose2 slipped = view.pose * Pose2{0.1, 0.0, 0.0};
    const ScanMatch match = view.match_from(slipped);
    const auto error_m = [&](double most_deviations) {
        FusionSettings settings;
        settings.most_deviations = most_deviations;
        const MatchContext context = view.context_of_degree(1.0, slipped, 0.002);
        return distance_m(InformationFusion(settings).correct(context, match).pose, view.pose);
    };
    EXPECT_LT(error_m(3.0), 0.8 * error_m(1e6));
    EXPECT_LT(error_m(1.0), 0.5 * error_m(3.0));
}

}  // namespace
}  // namespace ddtool

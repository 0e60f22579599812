#include "ddtool/filter/correlative_search.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>

#include "known_view.hpp"

namespace ddtool {
namespace {

TEST(NormalScatter, OfACorridorHasOneDirection) {
    const KnownView corridor(long_corridor(), 8.0);
    const Eigen::Matrix2d scatter = normal_scatter(corridor.match_points, 0.0);
    EXPECT_NEAR(scatter.trace(), 1.0, 1e-3);
    EXPECT_LT(scatter(0, 0), 0.005);
    const KnownView square(room(4.0, 4.0));
    EXPECT_GT(normal_scatter(square.match_points, 0.0)(0, 0), 0.3);
}

TEST(NormalScatter, TurnsWithTheRobot) {
    const KnownView corridor(long_corridor(), 8.0);
    const Eigen::Matrix2d turned = normal_scatter(corridor.match_points, 1.5707963267948966);
    EXPECT_LT(turned(1, 1), 0.005);
}

TEST(CorrelativeSearch, FindsThePoseInARoom) {
    KnownView view(furnished_room());
    const Pose2 odometry = view.pose * Pose2{0.1, -0.12, 0.06};
    const ScanMatch found = CorrelativeSearch({}).correct(view.context(odometry, odometry), {});
    EXPECT_LT(distance_m(found.pose, view.pose), 0.02);
    EXPECT_NEAR(found.pose.theta_rad, view.pose.theta_rad, 0.005);
}

TEST(CorrelativeSearch, KeepsTheOdometryAlongACorridor) {
    KnownView view(long_corridor(), 8.0);
    const Pose2 odometry = view.pose * Pose2{0.1, -0.12, 0.03};
    const ScanMatch found = CorrelativeSearch({}).correct(view.context(odometry, odometry), {});
    EXPECT_NEAR(found.pose.x_m, odometry.x_m, 0.01);
    EXPECT_NEAR(found.pose.y_m, view.pose.y_m, 0.02);
    EXPECT_NEAR(found.pose.theta_rad, view.pose.theta_rad, 0.005);
}

}  // namespace
}  // namespace ddtool

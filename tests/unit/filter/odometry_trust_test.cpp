#include "ddtool/filter/odometry_trust.hpp"

#include <gtest/gtest.h>

#include "known_view.hpp"

namespace ddtool {
namespace {

TEST(LidarTrust, IsThePapersAtItsQuarters) {
    EXPECT_NEAR(lidar_trust(0.0), 1.419, 5e-4);
    EXPECT_NEAR(lidar_trust(0.25), 1.228, 5e-4);
    EXPECT_NEAR(lidar_trust(0.5), 1.0, 5e-4);
    EXPECT_NEAR(lidar_trust(0.75), 0.729, 1e-3);
    EXPECT_NEAR(lidar_trust(1.0), 0.405, 1e-3);
}

TEST(LidarScoreTrust, FollowsTheOdometryOnlyWhereItFitsAboutAsWellAndTheScanIsDistrusted) {
    KnownView corridor(long_corridor(), 8.0);
    const Pose2 along = corridor.pose * Pose2{0.1, 0.0, 0.0};
    const ScanMatch match = corridor.matcher.evaluate(corridor.grid, corridor.match_points, corridor.pose);
    const auto trusted = [&](const Pose2& odometry, double degree) {
        return LidarScoreTrust().correct(corridor.context_of_degree(degree, odometry), match).pose;
    };
    EXPECT_EQ(trusted(along, 0.0), corridor.pose);
    EXPECT_EQ(trusted(along, 1.0), along);
    const Pose2 into_the_wall = corridor.pose * Pose2{0.0, 0.5, 0.0};
    EXPECT_EQ(trusted(into_the_wall, 1.0), corridor.pose);
}

TEST(OdometryTrust, ForgetsTheMatch) {
    KnownView view(furnished_room());
    const Pose2 odometry = view.pose * Pose2{0.3, 0.1, 0.2};
    const ScanMatch result = OdometryTrust().correct(view.context(odometry, odometry), view.match_from(view.pose));
    EXPECT_EQ(result.pose, odometry);
    EXPECT_TRUE(result.information.isZero());
}

TEST(EigenvalueGate, FallsBackToOdometryInACorridorOnly) {
    KnownView corridor(long_corridor(), 8.0);
    KnownView square(furnished_room());
    for (KnownView* view : {&corridor, &square}) {
        const Pose2 odometry = view->pose * Pose2{0.02, 0.01, 0.0};
        const ScanMatch match = view->match_from(view->pose);
        const Pose2 result = EigenvalueGate({}).correct(view->context(odometry, odometry), match).pose;
        EXPECT_EQ(result, view == &corridor ? odometry : match.pose);
    }
}

}  // namespace
}  // namespace ddtool

#include "swarm/moments.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "swarms.hpp"

namespace ddtool {
namespace {

TEST(PositionMoments, AreThoseOfASample) {
    PositionMoments moments;
    for (const Pose2& at : {Pose2{1.0, 2.0, 0.0}, Pose2{3.0, 2.0, 0.0}, Pose2{5.0, 8.0, 0.0}}) {
        moments.add(at);
    }
    EXPECT_DOUBLE_EQ(moments.mean().x_m, 3.0);
    EXPECT_DOUBLE_EQ(moments.mean().y_m, 4.0);
    EXPECT_DOUBLE_EQ(moments.covariance({1.0, 0.0}, {1.0, 0.0}), 4.0);
    EXPECT_DOUBLE_EQ(moments.covariance({1.0, 0.0}, {0.0, 1.0}), 6.0);
    EXPECT_DOUBLE_EQ(moments.covariance({0.0, 1.0}, {0.0, 1.0}), 12.0);
    EXPECT_DOUBLE_EQ(moments.covariance({1.0, 1.0}, {1.0, -1.0}), 4.0 - 12.0);
}

TEST(PositionMoments, DoNotCancelFarFromTheOrigin) {
    PositionMoments moments;
    for (const double x_m : {-0.001, 0.0, 0.001}) {
        moments.add({1e6 + x_m, -1e6, 0.0}, 0.2);
    }
    EXPECT_NEAR(moments.shape().major_variance_m2, 1e-6, 1e-12);
    EXPECT_EQ(moments.shape().minor_variance_m2, 0.0);
}

TEST(PositionMoments, LeaveOutWhatIsNotFiniteOrHasNoWeight) {
    PositionMoments moments;
    moments.add({-1.0, 0.0, 0.0});
    moments.add({1.0, 0.0, 0.0});
    moments.add({std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0});
    moments.add({0.0, std::numeric_limits<double>::infinity(), 0.0});
    moments.add({100.0, 0.0, 0.0}, 0.0);
    moments.add({100.0, 0.0, 0.0}, std::numeric_limits<double>::quiet_NaN());
    EXPECT_EQ(moments.mean().x_m, 0.0);
    EXPECT_EQ(moments.shape().major_variance_m2, 2.0);
}

TEST(PositionMoments, AreZeroForFewerThanTwo) {
    PositionMoments moments;
    EXPECT_EQ(moments.shape().major_variance_m2, 0.0);
    moments.add({7.0, 8.0, 0.0});
    EXPECT_EQ(moments.shape().major_variance_m2, 0.0);
    EXPECT_EQ(moments.covariance({1.0, 0.0}, {1.0, 0.0}), 0.0);
}

TEST(PoseScatter, IsAboutTheCentreGivenWithHeadingsWrapped) {
    std::vector<SnapshotParticle> swarm = test::swarm_at({{1.0, 0.0}, {1.0, 4.0}});
    swarm[0].pose.theta_rad = std::numbers::pi - 0.1;
    swarm[1].pose.theta_rad = -std::numbers::pi + 0.1;
    swarm[0].weight = 0.75;
    swarm[1].weight = 0.25;
    const Eigen::Matrix3d scatter = pose_scatter(swarm, {0.0, 0.0, std::numbers::pi - 0.1});
    const Eigen::Matrix3d expected = (Eigen::Matrix3d() << 1.0, 1.0, 0.05, 1.0, 4.0, 0.2, 0.05, 0.2, 0.01).finished();
    EXPECT_NEAR((scatter - expected).norm(), 0.0, 1e-12) << scatter;
}

TEST(PoseScatter, LeavesOutWhatIsNotFinite) {
    std::vector<SnapshotParticle> swarm = test::swarm_at({{1.0, 0.0}, {1.0, 4.0}});
    swarm[0].weight = swarm[1].weight = 0.5;
    swarm[1].pose.theta_rad = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(pose_scatter(swarm, {})(0, 0), 0.5);
}

}  // namespace
}  // namespace ddtool

#include "ddtool/filter/learnt_odometry.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "ddtool/base/random.hpp"

namespace ddtool {
namespace {

const Eigen::Matrix3d held = Eigen::Vector3d(1e5, 1e5, 1e6).asDiagonal();
const Eigen::Matrix3d lost_along = Eigen::Vector3d(0.0, 1e5, 1e6).asDiagonal();

struct Truth {
    double scale = 1.02;
    double bias_rad_per_s = -4e-4;
    double noise_m = 0.02;     ///< standard deviation per square root of a metre
    double noise_rad = 0.002;  ///< standard deviation per square root of a metre
};

/// Drives straight on in steps of 0.1 m, each of which takes 0.1 s.
void drive(LearntOdometry& odometry, double way_m, const Truth& truth, const Eigen::Matrix3d& information) {
    RandomStream random{7};
    const double root = std::sqrt(0.1);
    std::vector<Pose2> path{{}};
    const auto pose_before = [&](std::size_t updates) {
        return path[path.size() - 1 - std::min(updates, path.size() - 1)];
    };
    for (double driven_m = 0.0; driven_m < way_m; driven_m += 0.1) {
        const Pose2 true_motion{truth.scale * 0.1 + truth.noise_m * root * random.normal(), 0.0,
                                truth.bias_rad_per_s * 0.1 + truth.noise_rad * root * random.normal()};
        path.push_back(path.back() * true_motion);
        odometry.learn({{0.1, 0.0, 0.0}, 0.1, information, pose_before});
    }
}

TEST(LearntOdometry, FindsScaleBiasAndNoiseWhereTheScansHoldTheRobot) {
    LearntOdometry odometry;
    drive(odometry, 400.0, {}, held);
    EXPECT_NEAR(odometry.scale(), 1.02, 4.0 * 0.02 / std::sqrt(400.0));
    EXPECT_NEAR(odometry.bias_rad_per_s(), -4e-4, 4.0 * 0.002 / std::sqrt(400.0));
    EXPECT_NEAR(odometry.noise().translation_per_translation, 0.02, 0.003);
    EXPECT_NEAR(odometry.noise().rotation_per_translation, 0.002, 0.0005);
    const Pose2 expected = odometry.expected({1.0, 0.0, 0.0}, 2.0);
    EXPECT_NEAR(expected.x_m, odometry.scale(), 1e-12);
    EXPECT_NEAR(expected.theta_rad, 2.0 * odometry.bias_rad_per_s(), 1e-12);
}

TEST(LearntOdometry, LearnsNoScaleWhereTheWayIsNotHeldButTheTurnRate) {
    LearntOdometry odometry;
    drive(odometry, 100.0, {}, lost_along);
    EXPECT_EQ(odometry.scale(), 1.0);
    EXPECT_LT(odometry.bias_rad_per_s(), -1e-4);
}

TEST(LearntOdometry, GetsSurerWithEveryMetre) {
    LearntOdometry odometry;
    double last_sd = odometry.scale_sd();
    for (int part = 0; part < 5; ++part) {
        drive(odometry, 10.0, {}, held);
        EXPECT_LT(odometry.scale_sd(), last_sd);
        last_sd = odometry.scale_sd();
    }
}

TEST(LearntOdometry, OfNothingLearntIsTheOdometry) {
    const LearntOdometry odometry;
    EXPECT_EQ(odometry.expected({0.3, 0.1, -0.2}, 5.0), (Pose2{0.3, 0.1, -0.2}));
    const MotionSigmas sigmas = odometry.sigmas({1.0, 0.0, 0.0}, 0.0);
    EXPECT_GE(sigmas.x_m, OdometryLearning::caution * OdometryLearning::noise.translation_per_translation);
}

TEST(LearntOdometry, ASlipCountsLittle) {
    LearntOdometry slipped;
    LearntOdometry clean;
    for (LearntOdometry* odometry : {&slipped, &clean}) {
        drive(*odometry, 100.0, {}, held);
    }
    const auto moved = [](double x_m) {
        return [=](std::size_t updates) { return updates == 0 ? Pose2{x_m, 0.0, 0.0} : Pose2{}; };
    };
    slipped.learn({{1.0, 0.0, 0.0}, 1.0, held, moved(0.2)});
    clean.learn({{1.0, 0.0, 0.0}, 1.0, held, moved(1.02)});
    EXPECT_NEAR(slipped.scale(), clean.scale(), 2.0 * clean.scale_sd());
}

}  // namespace
}  // namespace ddtool

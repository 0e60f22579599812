#include "ddtool/swarm/motion_model.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>

namespace ddtool {
namespace {

constexpr MotionNoise no_noise{0.0, 0.0, 0.0, 0.0};

TEST(SampleMotion, WithoutNoiseIsTheOdometryMotion) {
    RandomStream random({1});
    const Pose2 motion{0.4, -0.1, 0.3};
    EXPECT_EQ(sample_motion(motion, motion_sigmas(motion, no_noise), random), motion);
}

TEST(SampleMotion, StandingStillSpreadsNothing) {
    RandomStream random({1});
    EXPECT_EQ(sample_motion({}, motion_sigmas({}, MotionNoise{}), random), Pose2{});
}

TEST(SampleMotion, HasTheStatedSpreadAlongTheMotion) {
    constexpr std::uint64_t samples = 20'000;
    const MotionNoise noise{0.1, 0.0, 0.0, 0.0};
    double sum = 0.0;
    double sum_of_squares = 0.0;
    for (std::uint64_t sample = 0; sample < samples; ++sample) {
        RandomStream random({7, sample});
        const double x = sample_motion({1.0, 0.0, 0.0}, motion_sigmas({1.0, 0.0, 0.0}, noise), random).x_m;
        sum += x;
        sum_of_squares += x * x;
    }
    const double mean = sum / samples;
    const double sigma = std::sqrt(sum_of_squares / samples - mean * mean);
    // The bounds are five standard errors of the mean and of the standard deviation.
    EXPECT_NEAR(mean, 1.0, 5.0 * 0.1 / std::sqrt(samples));
    EXPECT_NEAR(sigma, 0.1, 5.0 * 0.1 / std::sqrt(2.0 * samples));
}

Pose2 part_of(const Pose2& motion, double share) {
    return {share * motion.x_m, share * motion.y_m, share * motion.theta_rad};
}

TEST(MotionSigmas, VariancesAddUpOverSteps) {
    constexpr int steps = 7;
    for (const Pose2& motion :
         {Pose2{1.4, 0.0, 0.0}, Pose2{-0.3, 0.8, 0.0}, Pose2{0.0, 0.0, -1.2}, Pose2{2.0, -0.5, 0.9}}) {
        const MotionSigmas whole = motion_sigmas(motion, MotionNoise{});
        const MotionSigmas part = motion_sigmas(part_of(motion, 1.0 / steps), MotionNoise{});
        EXPECT_NEAR(steps * part.x_m * part.x_m, whole.x_m * whole.x_m, 1e-12);
        EXPECT_NEAR(steps * part.y_m * part.y_m, whole.y_m * whole.y_m, 1e-12);
        EXPECT_NEAR(steps * part.theta_rad * part.theta_rad, whole.theta_rad * whole.theta_rad, 1e-12);
    }
}

TEST(MotionSigmas, OfGMappingGrowInProportionToTheMotion) {
    constexpr double share = 0.25;
    const Pose2 motion{1.2, -0.4, 0.6};
    const MotionSigmas whole = motion_sigmas(motion, LinearMotionNoise{});
    const MotionSigmas part = motion_sigmas(part_of(motion, share), LinearMotionNoise{});
    EXPECT_NEAR(part.x_m, share * whole.x_m, 1e-15);
    EXPECT_NEAR(part.y_m, share * whole.y_m, 1e-15);
    EXPECT_NEAR(part.theta_rad, share * whole.theta_rad, 1e-15);
    EXPECT_DOUBLE_EQ(whole.x_m, 0.1 * (1.2 + 0.3 * 0.4) + 0.1 * 0.6);
    EXPECT_DOUBLE_EQ(whole.y_m, 0.1 * (0.4 + 0.3 * 1.2) + 0.1 * 0.6);
    EXPECT_DOUBLE_EQ(whole.theta_rad, 0.2 * std::hypot(1.2, 0.4) + 0.2 * 0.6);
}

TEST(MotionSigmas, DoNotDependOnTheSign) {
    const MotionSigmas there = motion_sigmas({0.7, -0.2, 0.4}, MotionNoise{});
    const MotionSigmas back = motion_sigmas({-0.7, 0.2, -0.4}, MotionNoise{});
    EXPECT_EQ(there.x_m, back.x_m);
    EXPECT_EQ(there.y_m, back.y_m);
    EXPECT_EQ(there.theta_rad, back.theta_rad);
}

struct Spread {
    double x = 0.0, y = 0.0, theta = 0.0;
};

/// The variances of the final pose after a straight metre that is driven in `steps` steps.
Spread spread_after_a_metre(int steps, const MotionNoise& noise) {
    constexpr std::uint64_t samples = 20'000;
    const Pose2 step{1.0 / steps, 0.0, 0.0};
    Spread variance;
    for (std::uint64_t sample = 0; sample < samples; ++sample) {
        RandomStream random({static_cast<std::uint64_t>(steps), sample});
        Pose2 pose;
        for (int i = 0; i < steps; ++i) {
            pose = pose * sample_motion(step, motion_sigmas(step, noise), random);
        }
        variance.x += (pose.x_m - 1.0) * (pose.x_m - 1.0) / samples;
        variance.y += pose.y_m * pose.y_m / samples;
        variance.theta += pose.theta_rad * pose.theta_rad / samples;
    }
    return variance;
}

TEST(SampleMotion, SpreadsAsFarInShortStepsAsInALongOne) {
    MotionNoise noise;
    noise.rotation_per_translation = 0.01;  // small, because an error of the heading carries later steps sideways
    const Spread one = spread_after_a_metre(1, noise);
    const Spread many = spread_after_a_metre(10, noise);
    // of the ratio of two variances, each from 20000 samples
    constexpr double five_standard_errors = 5.0 * 2.0 / 141.0;
    EXPECT_NEAR(many.x / one.x, 1.0, five_standard_errors);
    EXPECT_NEAR(many.theta / one.theta, 1.0, five_standard_errors);
    EXPECT_NEAR(many.y / one.y, 1.0, five_standard_errors + 0.05);
}

}  // namespace
}  // namespace ddtool

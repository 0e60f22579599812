#include "particles/motion_model.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>

namespace ddtool {
namespace {

constexpr MotionNoise no_noise{0.0, 0.0, 0.0, 0.0};

TEST(SampleMotion, WithoutNoiseIsTheOdometryMotion) {
    RandomStream random({1});
    const Pose2 motion{0.4, -0.1, 0.3};
    EXPECT_EQ(sample_motion(motion, no_noise, random), motion);
}

TEST(SampleMotion, StandingStillSpreadsNothing) {
    RandomStream random({1});
    EXPECT_EQ(sample_motion({}, MotionNoise{}, random), Pose2{});
}

TEST(SampleMotion, HasTheStatedSpreadAlongTheMotion) {
    constexpr std::uint64_t samples = 20'000;
    const MotionNoise noise{0.1, 0.0, 0.0, 0.0};
    double sum = 0.0;
    double sum_of_squares = 0.0;
    for (std::uint64_t sample = 0; sample < samples; ++sample) {
        RandomStream random({7, sample});
        const double x = sample_motion({1.0, 0.0, 0.0}, noise, random).x_m;
        sum += x;
        sum_of_squares += x * x;
    }
    const double mean = sum / samples;
    const double sigma = std::sqrt(sum_of_squares / samples - mean * mean);
    // Five standard errors of the mean and of the standard deviation.
    EXPECT_NEAR(mean, 1.0, 5.0 * 0.1 / std::sqrt(samples));
    EXPECT_NEAR(sigma, 0.1, 5.0 * 0.1 / std::sqrt(2.0 * samples));
}

}  // namespace
}  // namespace ddtool

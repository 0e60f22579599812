#include "sim/wheel_odometry.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "ddtool/base/error.hpp"

namespace ddtool::sim {
namespace {

constexpr OdometrySettings perfect{.scale_error_sd = 0.0,
                                   .gyro_bias_sd_rad_per_s = 0.0,
                                   .distance_noise_m_per_sqrt_m = 0.0,
                                   .heading_noise_rad_per_sqrt_m = 0.0,
                                   .heading_noise_rad_per_sqrt_rad = 0.0,
                                   .slips_per_m = 0.0};

constexpr std::int64_t step_ns = 10'000'000;

/// A drive along x at 1 m/s.
Trajectory straight(double length_m) {
    Trajectory trajectory;
    for (int i = 0; i <= static_cast<int>(std::lround(length_m * 100.0)); ++i) {
        trajectory.push_back({i * step_ns, {0.01 * i, 0.0, 0.0}});
    }
    return trajectory;
}

/// A turn in place at 1 rad/s.
Trajectory turning(double turns_rad) {
    Trajectory trajectory;
    for (int i = 0; i <= static_cast<int>(turns_rad * 100.0); ++i) {
        trajectory.push_back({i * step_ns, {0.0, 0.0, wrap_angle(0.01 * i)}});
    }
    return trajectory;
}

TEST(WheelOdometry, MeasuresTurnsTooLargeByTheirError) {
    OdometrySettings settings = perfect;
    settings.turn_error = 0.05;
    EXPECT_NEAR(simulate_odometry(turning(2.0), settings, 1).back().pose.theta_rad, 2.1, 1e-6);
}

struct Spread {
    double mean;
    double sd;
};

/// The mean and the spread, over many seeds, of a number that is computed from the last pose of the odometry.
template <typename Number>
Spread spread_of(const Trajectory& truth, const OdometrySettings& settings, std::uint64_t seeds, Number number) {
    double sum = 0.0;
    double squares = 0.0;
    for (std::uint64_t seed = 0; seed < seeds; ++seed) {
        const double value = number(simulate_odometry(truth, settings, seed).back().pose);
        sum += value;
        squares += value * value;
    }
    const double mean = sum / static_cast<double>(seeds);
    return {mean, std::sqrt(squares / static_cast<double>(seeds) - mean * mean)};
}

constexpr std::uint64_t seeds = 400;
/// Five relative standard errors of a standard deviation that is estimated from `seeds` normal samples.
const double sd_bound = 5.0 / std::sqrt(2.0 * seeds);

double x_of(const Pose2& pose) { return pose.x_m; }
double heading_of(const Pose2& pose) { return pose.theta_rad; }

TEST(WheelOdometry, WithoutErrorsIsTheTruthSeenFromTheStart) {
    Trajectory truth = straight(3.0);
    for (StampedPose& stamped : truth) {
        stamped.pose = Pose2{5.0, -1.0, 2.0} * stamped.pose;
    }
    for (const StampedPose& stamped : simulate_odometry(truth, perfect, 1)) {
        const Pose2 expected = between(truth.front().pose, *pose_at(truth, stamped.stamp_ns));
        EXPECT_NEAR(distance_m(stamped.pose, expected), 0.0, 1e-9);
        EXPECT_NEAR(wrap_angle(stamped.pose.theta_rad - expected.theta_rad), 0.0, 1e-9);
    }
}

TEST(WheelOdometry, ScaleErrorHasTheStatedSpread) {
    OdometrySettings settings = perfect;
    settings.scale_error_sd = 0.02;
    const Spread spread = spread_of(straight(2.0), settings, seeds, x_of);
    EXPECT_NEAR(spread.mean, 2.0, 5.0 * 0.04 / std::sqrt(seeds));
    EXPECT_NEAR(spread.sd, 0.04, 0.04 * sd_bound);
}

TEST(WheelOdometry, GyroBiasGrowsWithTime) {
    OdometrySettings settings = perfect;
    settings.gyro_bias_sd_rad_per_s = 0.01;
    const Spread spread = spread_of(straight(2.0), settings, seeds, heading_of);
    EXPECT_NEAR(spread.sd, 0.02, 0.02 * sd_bound);
}

TEST(WheelOdometry, NoiseGrowsWithTheRootOfTheMotionAtAnyRate) {
    for (const double rate_hz : {10.0, 50.0}) {
        OdometrySettings settings = perfect;
        settings.rate_hz = rate_hz;
        settings.distance_noise_m_per_sqrt_m = 0.1;
        settings.heading_noise_rad_per_sqrt_rad = 0.05;
        const double distance_sd = 0.1 * std::sqrt(4.0);
        EXPECT_NEAR(spread_of(straight(4.0), settings, seeds, x_of).sd, distance_sd, distance_sd * sd_bound);
        const double heading_sd = 0.05 * std::sqrt(3.0);
        EXPECT_NEAR(
            spread_of(turning(3.0), settings, seeds, [](const Pose2& pose) { return wrap_angle(pose.theta_rad - 3.0); })
                .sd,
            heading_sd, heading_sd * sd_bound);
    }
}

TEST(WheelOdometry, HeadingNoiseGrowsWithTheRootOfTheDistance) {
    OdometrySettings settings = perfect;
    settings.heading_noise_rad_per_sqrt_m = 0.02;
    EXPECT_NEAR(spread_of(straight(4.0), settings, seeds, heading_of).sd, 0.04, 0.04 * sd_bound);
}

TEST(WheelOdometry, SlipsAddTheirMeanDistance) {
    OdometrySettings settings = perfect;
    settings.slips_per_m = 1.0;
    settings.slip_m = 0.05;
    // The sum of a Poisson number of exponential slips, with the mean number n and the mean slip s, has the mean n s
    // and the variance 2 n s^2.
    const double slips = 5.0;
    const double sd = 0.05 * std::sqrt(2.0 * slips);
    const Spread spread = spread_of(straight(5.0), settings, seeds, x_of);
    EXPECT_NEAR(spread.mean, 5.0 + slips * 0.05, 5.0 * sd / std::sqrt(seeds));
    EXPECT_NEAR(spread.sd, sd, 2.0 * sd * sd_bound);
}

TEST(WheelOdometry, StandingStillOnlyTheGyroDrifts) {
    const Trajectory still{{0, {}}, {1'000'000'000, {}}};
    OdometrySettings settings = odometry_preset("poor");
    settings.gyro_bias_sd_rad_per_s = 0.0;
    EXPECT_EQ(simulate_odometry(still, settings, 3).back().pose, Pose2{});
}

TEST(WheelOdometry, CoversTheWholeDriveAtItsRate) {
    const Trajectory truth = straight(1.505);
    const Trajectory odometry = simulate_odometry(truth, {.rate_hz = 30.0}, 1);
    EXPECT_EQ(odometry.front().stamp_ns, truth.front().stamp_ns);
    EXPECT_GE(odometry.back().stamp_ns, truth.back().stamp_ns);
    // the start, and the 46 steps of 1/30 s that are needed to pass 1.505 s (or 1.51 s)
    EXPECT_EQ(odometry.size(), 47U);
}

TEST(WheelOdometry, PresetsAreOrdered) {
    const double good = spread_of(straight(20.0), odometry_preset("good"), 50, heading_of).sd;
    const double typical = spread_of(straight(20.0), odometry_preset("typical"), 50, heading_of).sd;
    const double poor = spread_of(straight(20.0), odometry_preset("poor"), 50, heading_of).sd;
    EXPECT_LT(good, typical);
    EXPECT_LT(typical, poor);
    EXPECT_THROW(odometry_preset("perfect"), UsageError);
}

}  // namespace
}  // namespace ddtool::sim

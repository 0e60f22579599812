#include "sim/inertial_sensor.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace ddtool::sim {
namespace {

/// A turn in place of 20 s, at up to 1 rad/s to and fro.
Trajectory turning() {
    Trajectory trajectory;
    for (std::int64_t i = 0; i <= 2000; ++i) {
        trajectory.push_back({i * 10'000'000, {0.0, 0.0, std::sin(0.01 * static_cast<double>(i))}});
    }
    return trajectory;
}

double mean_of(const std::vector<StampedTurnRate>& readings) {
    double sum = 0.0;
    for (const StampedTurnRate& reading : readings) {
        sum += reading.rad_per_s;
    }
    return sum / static_cast<double>(readings.size());
}

TEST(InertialSensor, MeasuresTheTurnsWithoutNoise) {
    const ImuSettings exact{.rate_hz = 50.0, .bias_sd_rad_per_s = 0.0, .noise_rad_per_sqrt_s = 0.0};
    const auto readings = simulate_gyro(turning(), exact, 1);
    ASSERT_EQ(readings.size(), 1000U);
    for (const StampedTurnRate& reading : readings) {
        EXPECT_NEAR(reading.rad_per_s, std::cos(1e-9 * static_cast<double>(reading.stamp_ns)), 1e-3);
    }
}

TEST(InertialSensor, HasABiasForEachRunAndNoiseThatDoesNotDependOnItsRate) {
    for (const double rate_hz : {20.0, 100.0}) {
        const ImuSettings noisy{.rate_hz = rate_hz, .bias_sd_rad_per_s = 0.0, .noise_rad_per_sqrt_s = 0.01};
        double squares = 0.0;
        for (std::uint64_t seed = 0; seed < 200; ++seed) {
            const double turn_rad = 20.0 * mean_of(simulate_gyro(turning(), noisy, seed));
            squares += std::pow(turn_rad - std::sin(20.0), 2);
        }
        EXPECT_NEAR(std::sqrt(squares / 200.0), 0.01 * std::sqrt(20.0), 0.01) << rate_hz;
    }
    const ImuSettings biased{.rate_hz = 50.0, .bias_sd_rad_per_s = 0.1, .noise_rad_per_sqrt_s = 0.0};
    EXPECT_NE(mean_of(simulate_gyro(turning(), biased, 1)), mean_of(simulate_gyro(turning(), biased, 2)));
}

TEST(InertialSensor, IsNotThereAtARateOfZero) { EXPECT_TRUE(simulate_gyro(turning(), {}, 1).empty()); }

}  // namespace
}  // namespace ddtool::sim

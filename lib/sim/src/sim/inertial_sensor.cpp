#include "sim/inertial_sensor.hpp"

#include <cmath>

#include "ddtool/base/random.hpp"
#include "sim/random_purpose.hpp"

namespace ddtool::sim {

std::vector<StampedTurnRate> simulate_gyro(const Trajectory& truth, const ImuSettings& settings, std::uint64_t seed) {
    std::vector<StampedTurnRate> readings;
    if (!(settings.rate_hz > 0.0)) {
        return readings;
    }
    const double bias_rad_per_s = settings.bias_sd_rad_per_s * RandomStream({seed, imu_run}).normal();
    const double noise_rad_per_s = settings.noise_rad_per_sqrt_s * std::sqrt(settings.rate_hz);
    const auto step_ns = static_cast<std::int64_t>(std::llround(1e9 / settings.rate_hz));
    Pose2 before = truth.front().pose;
    for (std::uint64_t step = 1;; ++step) {
        const std::int64_t stamp_ns = truth.front().stamp_ns + static_cast<std::int64_t>(step) * step_ns;
        if (stamp_ns > truth.back().stamp_ns) {
            return readings;
        }
        const Pose2 now = *pose_at(truth, stamp_ns);
        const double rate_rad_per_s = 1e9 * between(before, now).theta_rad / static_cast<double>(step_ns);
        const double noise = noise_rad_per_s * RandomStream({seed, imu_step, step}).normal();
        readings.push_back({stamp_ns - step_ns / 2, rate_rad_per_s + bias_rad_per_s + noise});
        before = now;
    }
}

}  // namespace ddtool::sim

#include "sim/wheel_odometry.hpp"

#include <cmath>
#include <map>

#include "ddtool/base/error.hpp"
#include "ddtool/base/random.hpp"
#include "ddtool/system/settings.hpp"
#include "sim/random_purpose.hpp"

namespace ddtool::sim {
namespace {

const std::map<std::string, OdometrySettings>& odometry_presets() {
    static const std::map<std::string, OdometrySettings> table{
        {"good",
         {.scale_error_sd = 0.001,
          .gyro_bias_sd_rad_per_s = 2.0e-5,
          .distance_noise_m_per_sqrt_m = 0.005,
          .heading_noise_rad_per_sqrt_m = 3.0e-4,
          .heading_noise_rad_per_sqrt_rad = 1.0e-3,
          .slips_per_m = 0.0,
          .slip_m = 0.0,
          .slip_rad = 0.0}},
        {"typical", {}},
        {"poor",
         {.scale_error_sd = 0.02,
          .gyro_bias_sd_rad_per_s = 8.0e-4,
          .distance_noise_m_per_sqrt_m = 0.03,
          .heading_noise_rad_per_sqrt_m = 8.0e-3,
          .heading_noise_rad_per_sqrt_rad = 2.0e-2,
          .slips_per_m = 0.05,
          .slip_m = 0.05,
          .slip_rad = 1.0e-2}},
    };
    return table;
}

class OdometryErrors {
public:
    OdometryErrors(const OdometrySettings& settings, std::uint64_t seed) : settings_(settings), seed_(seed) {
        RandomStream random({seed, odometry_run});
        scale_ = 1.0 + settings.scale_error_sd * random.normal();
        bias_rad_per_s_ = settings.gyro_bias_sd_rad_per_s * random.normal();
    }

    /// The motion that the odometry reports for a true motion, both in the robot's frame.
    [[nodiscard]] Pose2 measure(const Pose2& motion, double duration_s, std::uint64_t step) const {
        RandomStream random({seed_, odometry_step, step});
        const double length_m = std::hypot(motion.x_m, motion.y_m);
        const double turn_rad = std::abs(motion.theta_rad);
        double along_m = settings_.distance_noise_m_per_sqrt_m * std::sqrt(length_m) * random.normal();
        double heading_rad = bias_rad_per_s_ * duration_s;
        heading_rad += settings_.heading_noise_rad_per_sqrt_m * std::sqrt(length_m) * random.normal();
        heading_rad += settings_.heading_noise_rad_per_sqrt_rad * std::sqrt(turn_rad) * random.normal();
        if (random.uniform() < settings_.slips_per_m * length_m) {
            along_m -= settings_.slip_m * std::log(1.0 - random.uniform());
            heading_rad += settings_.slip_rad * random.normal();
        }
        return {scale_ * motion.x_m + along_m, scale_ * motion.y_m,
                wrap_angle((1.0 + settings_.turn_error) * motion.theta_rad + heading_rad)};
    }

private:
    OdometrySettings settings_;
    std::uint64_t seed_;
    double scale_ = 1.0;
    double bias_rad_per_s_ = 0.0;
};

}  // namespace

OdometrySettings odometry_preset(const std::string& name) {
    const auto found = odometry_presets().find(name);
    if (found == odometry_presets().end()) {
        throw UsageError("unknown odometry '" + name + "'; expected good, typical or poor");
    }
    return found->second;
}

std::vector<std::string> odometry_preset_names() { return {"good", "typical", "poor"}; }

Trajectory simulate_odometry(const Trajectory& truth, const OdometrySettings& settings, std::uint64_t seed) {
    const OdometryErrors errors(settings, seed);
    const std::int64_t start_ns = truth.front().stamp_ns;
    Trajectory odometry{{start_ns, {}}};
    Pose2 last_true = truth.front().pose;
    for (std::uint64_t step = 1; odometry.back().stamp_ns < truth.back().stamp_ns; ++step) {
        const std::int64_t stamp_ns =
            start_ns + static_cast<std::int64_t>(std::llround(1e9 * static_cast<double>(step) / settings.rate_hz));
        const Pose2 now_true = pose_at(truth, stamp_ns).value_or(truth.back().pose);
        const double duration_s = 1e-9 * static_cast<double>(stamp_ns - odometry.back().stamp_ns);
        const Pose2 measured = errors.measure(between(last_true, now_true), duration_s, step);
        odometry.push_back({stamp_ns, odometry.back().pose * measured});
        last_true = now_true;
    }
    return odometry;
}

}  // namespace ddtool::sim

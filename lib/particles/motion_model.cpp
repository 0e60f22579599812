#include "particles/motion_model.hpp"

#include <cmath>

namespace ddtool {
namespace {

/// Share of the noise of a translation that goes across it, GMapping's constant.
constexpr double cross_share = 0.3;

}  // namespace

Pose2 sample_motion(const Pose2& odometry_motion, const MotionNoise& noise, RandomStream& random) {
    const double along = std::abs(odometry_motion.x_m);
    const double across = std::abs(odometry_motion.y_m);
    const double turn = std::abs(odometry_motion.theta_rad);
    const double from_turn = noise.translation_per_rotation_m_per_rad * turn;
    const double sigma_x = noise.translation_per_translation * (along + cross_share * across) + from_turn;
    const double sigma_y = noise.translation_per_translation * (across + cross_share * along) + from_turn;
    const double sigma_theta =
        noise.rotation_per_translation_rad_per_m * std::hypot(along, across) + noise.rotation_per_rotation * turn;
    const double x = odometry_motion.x_m + sigma_x * random.normal();
    const double y = odometry_motion.y_m + sigma_y * random.normal();
    return {x, y, wrap_angle(odometry_motion.theta_rad + sigma_theta * random.normal())};
}

}  // namespace ddtool

#include "ddtool/swarm/motion_model.hpp"

#include <cmath>

namespace ddtool {
namespace {

constexpr double side_share = 0.3;  // share of the noise along the motion that also acts across it, as in GMapping

}  // namespace

MotionSigmas motion_sigmas(const Pose2& odometry_motion, const MotionNoise& noise) {
    const auto square = [](double value) { return value * value; };
    const double along = std::abs(odometry_motion.x_m);
    const double across = std::abs(odometry_motion.y_m);
    const double turn = std::abs(odometry_motion.theta_rad);
    const double per_m = square(noise.translation_per_translation);
    const double from_turn = square(noise.translation_per_rotation) * turn;
    return {std::sqrt(per_m * (along + square(side_share) * across) + from_turn),
            std::sqrt(per_m * (across + square(side_share) * along) + from_turn),
            std::sqrt(square(noise.rotation_per_translation) * std::hypot(along, across) +
                      square(noise.rotation_per_rotation) * turn)};
}

MotionSigmas motion_sigmas(const Pose2& odometry_motion, const LinearMotionNoise& noise) {
    const double along = std::abs(odometry_motion.x_m);
    const double across = std::abs(odometry_motion.y_m);
    const double turn = std::abs(odometry_motion.theta_rad);
    const double per_m = noise.translation_per_translation;
    const double from_turn = noise.translation_per_rotation * turn;
    return {per_m * (along + side_share * across) + from_turn, per_m * (across + side_share * along) + from_turn,
            noise.rotation_per_translation * std::hypot(along, across) + noise.rotation_per_rotation * turn};
}

Pose2 sample_motion(const Pose2& odometry_motion, const MotionSigmas& sigmas, RandomStream& random) {
    const double x = odometry_motion.x_m + sigmas.x_m * random.normal();
    const double y = odometry_motion.y_m + sigmas.y_m * random.normal();
    return {x, y, wrap_angle(odometry_motion.theta_rad + sigmas.theta_rad * random.normal())};
}

}  // namespace ddtool

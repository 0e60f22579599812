#pragma once

#include "ddtool/base/random.hpp"
#include "ddtool/robot/pose2.hpp"

namespace ddtool {

/// Noise of the odometry motion model. Its variance grows with the motion, so that a way driven in many short steps
/// spreads the swarm as much as in one long step, whatever the distance between updates. The defaults are GMapping's
/// at its step of one metre and one radian.
struct MotionNoise {
    double translation_per_translation = 0.1;  ///< m per sqrt(m)
    double translation_per_rotation = 0.1;     ///< m per sqrt(rad)
    double rotation_per_translation = 0.1;     ///< rad per sqrt(m)
    double rotation_per_rotation = 0.2;        ///< rad per sqrt(rad)
};

/// Standard deviations of the motion in the robot's previous frame, for an odometry motion. Zero where nothing moved.
struct MotionSigmas {
    double x_m = 0.0;
    double y_m = 0.0;
    double theta_rad = 0.0;
};

/// Along, across and turn are drawn apart, as GMapping does; the rotate-translate-rotate model of Thrun et al. 2005,
/// table 5.6, is singular for small motions.
MotionSigmas motion_sigmas(const Pose2& odometry_motion, const MotionNoise& noise);

/// One sample of the motion that odometry reported as `odometry_motion`: zero-mean normal noise of those sizes.
Pose2 sample_motion(const Pose2& odometry_motion, const MotionNoise& noise, RandomStream& random);

}  // namespace ddtool

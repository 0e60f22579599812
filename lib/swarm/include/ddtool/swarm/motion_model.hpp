#pragma once

#include "ddtool/base/random.hpp"
#include "ddtool/robot/pose2.hpp"

namespace ddtool {

/// Noise of the odometry motion model. Its variance grows in proportion to the motion, so that a distance driven in
/// many short steps spreads the swarm as much as one long step, whatever the distance between updates. The defaults are
/// those of GMapping at its step of one metre and one radian.
struct MotionNoise {
    double translation_per_translation = 0.1;  ///< m per sqrt(m)
    double translation_per_rotation = 0.1;     ///< m per sqrt(rad)
    double rotation_per_translation = 0.1;     ///< rad per sqrt(m)
    double rotation_per_rotation = 0.2;        ///< rad per sqrt(rad)
};

/// Noise of GMapping's motion model: its standard deviation, not its variance, grows in proportion to the motion, so
/// that a distance driven in many steps spreads the swarm less than one step. The defaults are those of slam_gmapping,
/// whose names are srr, str, srt and stt.
struct LinearMotionNoise {
    double translation_per_translation = 0.1;  ///< m per m
    double translation_per_rotation = 0.1;     ///< m per rad
    double rotation_per_translation = 0.2;     ///< rad per m
    double rotation_per_rotation = 0.2;        ///< rad per rad
};

/// Standard deviations of the motion in the robot's previous frame, given an odometry motion. They are zero where the
/// odometry did not move.
struct MotionSigmas {
    double x_m = 0.0;
    double y_m = 0.0;
    double theta_rad = 0.0;
};

/// The noise along, across and in turn is drawn independently, as GMapping does it. The rotate-translate-rotate model
/// of Thrun et al. 2005, table 5.6, is not used because it is singular for small motions.
MotionSigmas motion_sigmas(const Pose2& odometry_motion, const MotionNoise& noise);
MotionSigmas motion_sigmas(const Pose2& odometry_motion, const LinearMotionNoise& noise);

/// One sample of the true motion, given the motion that the odometry reported: `odometry_motion` plus zero-mean normal
/// noise with the deviations.
Pose2 sample_motion(const Pose2& odometry_motion, const MotionSigmas& sigmas, RandomStream& random);

}  // namespace ddtool

#pragma once

#include "base/random.hpp"
#include "geometry/pose2.hpp"

namespace ddtool {

/// Noise of the odometry motion model, as standard deviations that grow with the motion between two updates.
struct MotionNoise {
    double translation_per_translation = 0.1;         ///< m per m
    double translation_per_rotation_m_per_rad = 0.1;  ///< m per rad
    double rotation_per_translation_rad_per_m = 0.1;  ///< rad per m
    double rotation_per_rotation = 0.2;               ///< rad per rad
};

/// One sample of the motion (in the robot's previous frame) that odometry reported as `odometry_motion`, with
/// zero-mean normal noise along, across and in heading, as GMapping draws it (the rotate-translate-rotate model of
/// Thrun et al. 2005, table 5.6, is singular for small motions).
Pose2 sample_motion(const Pose2& odometry_motion, const MotionNoise& noise, RandomStream& random);

}  // namespace ddtool

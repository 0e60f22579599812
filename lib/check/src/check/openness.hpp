#pragma once

#include "check/sight.hpp"

namespace ddtool::check {

/// What a scan tells of how far the robot came.
enum class Openness {
    held,   ///< it tells the position along the motion
    walls,  ///< its surfaces lie along the motion, as the walls of a bare corridor do
    blind   ///< it sees hardly any surface
};

/// \param motion the robot's motion that led to the scan, in the robot's frame
Openness openness_of(const Sight& sight, const Pose2& motion);

}  // namespace ddtool::check

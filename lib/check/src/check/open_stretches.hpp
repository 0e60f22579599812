#pragma once

#include <vector>

#include "check/kept_scans.hpp"

namespace ddtool::check {

/// How far the robot drove by its odometry and by the path where the scans leave open how far it came, as along a bare
/// corridor, and where they hold it.
struct OpenStretches {
    double odometry_m = 0.0;
    double path_m = 0.0;  ///< along the odometry's direction
    double worst_m = 0.0;  ///< the largest difference that adds up on one stretch without an end
    double held_odometry_m = 0.0;
    double held_path_m = 0.0;
    double held_worst = 0.0;
};

OpenStretches open_stretches(const std::vector<KeptScan>& scans, const std::vector<Pose2>& poses);

}  // namespace ddtool::check

#pragma once

#include <Eigen/Core>

#include "ddtool/robot/scan_points.hpp"

namespace ddtool {

/// Information that matching a scan gives of the robot's pose (x, y, theta in the robot's frame; 1/m^2, 1/m and 1), as
/// far as the scan itself can tell: each end point holds the robot across the surface it shows, with a standard
/// deviation of point_sd_m. Points whose neighbours form no line hold it both ways. Surface normals come from the
/// ranges and their noise, so a bare wall never seems to hold nothing along itself: good for ranks, not for zero.
Eigen::Matrix3d scan_information(const ScanPoints& points, double point_sd_m);

}  // namespace ddtool

#pragma once

#include <Eigen/Core>

#include "ddtool/robot/scan_points.hpp"

namespace ddtool {

/// The information about the robot's pose (x, y, theta in the robot's frame; in 1/m^2, 1/m and 1) that matching this
/// scan gives, estimated from the scan itself: each end point determines the position across the surface on which it
/// lies, with a standard deviation of point_sd_m; a point whose neighbours form no line determines it in both
/// directions. The surface normals are estimated from noisy ranges, so that even a bare wall seems to determine the
/// position along itself a little. The result is therefore good for ordering scans, but never zero where it should be.
/// \param points in the robot's frame
/// \param point_sd_m standard deviation of an end point, in metres
Eigen::Matrix3d scan_information(const ScanPoints& points, double point_sd_m);

}  // namespace ddtool

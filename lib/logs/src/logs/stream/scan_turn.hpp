#pragma once

#include <optional>

#include "ddtool/robot/laser_scan.hpp"

namespace ddtool {

/// By how much the lidar turned between two scans, in radians, counter-clockwise; from the ranges alone, as logged.
///
/// The first estimate is the shift by which the one profile of ranges fits the other best. It is refined together with
/// the motion in the plane by least squares on the range flow: a point at bearing b and range r is seen after the
/// motion (x, y, turn) at the bearing b - turn + (x sin b - y cos b) / r and the range r - x cos b - y sin b (Jaimez et
/// al., RF2O, ICRA 2016). Turns of more than 0.7 rad are not found. Nullopt if the scans do not have the same
/// directions, or if too few beams fit.
std::optional<double> turn_between(const LaserScan& before, const LaserScan& after);

}  // namespace ddtool

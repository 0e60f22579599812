#pragma once

#include <optional>

#include "ddtool/robot/laser_scan.hpp"
#include "ddtool/robot/pose2.hpp"

namespace ddtool {

/// How the lidar moved between two scans, from the ranges alone, as logged: its pose after the second in its axes at
/// the first. The turn of turn_between() is refined together with the position by laying the points of the second scan
/// on lines through those of the first (Censi, "An ICP variant using a point-to-line metric", ICRA 2008), which are
/// found by their bearings, so that the lidar must not have moved by more than some decimetres. The lines are as long
/// as the noise of the ranges requires: short ones would look as if a bare wall held the position along itself. That,
/// and that it needs no guess, is what align_scans() of robot/scan_alignment.hpp does not offer; it is made for turns.
///
/// Nullopt if the turn is not found, if too few points fit, or if the scans do not determine the position in every
/// direction, as in a corridor.
std::optional<Pose2> motion_between(const LaserScan& before, const LaserScan& after);

}  // namespace ddtool

#pragma once

#include <string>

#include "ddtool/robot/laser_scan.hpp"

namespace ddtool {

/// What the angles of a scan can be, by how much its beams cover.
enum class ScanAngles {
    radians,
    degrees,     ///< as radians its beams would cover many turns, as degrees a part of one
    impossible,  ///< its beams cover more than a full turn, or have no directions
};

/// Reads the angles of a logged scan: those in degrees are turned into radians.
ScanAngles read_angles(LaserScan& scan);

/// Why a scan with impossible angles cannot be used: "a scan whose beams cover 720 degrees, ...".
std::string angle_fault(const LaserScan& scan);

}  // namespace ddtool

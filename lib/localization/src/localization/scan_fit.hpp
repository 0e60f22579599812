#pragma once

#include <cstddef>

#include "ddtool/filter/occupancy_grid.hpp"
#include "ddtool/robot/scan_points.hpp"

namespace ddtool::localization {

/// How a scan fits a map at a pose.
struct ScanFit {
    std::size_t points = 0;
    std::size_t known = 0;   ///< points that end in ground that the map observed
    std::size_t agreed = 0;  ///< of those, the ones that end on a wall of the map

    /// The share of the points that the map explains, 0..1: those on a wall, among the known ones and half of the
    /// others. A map need not show all that the lidar sees, but where it shows nothing it explains nothing. 0 for a
    /// scan without points.
    [[nodiscard]] double support() const {
        const double counted = 0.5 * static_cast<double>(points + known);
        return counted > 0.0 ? static_cast<double>(agreed) / counted : 0.0;
    }
};

/// \param pose map_from_robot
ScanFit scan_fit(const ScanPoints& points, const OccupancyGrid& map, const Pose2& pose);

}  // namespace ddtool::localization

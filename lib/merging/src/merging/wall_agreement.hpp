#pragma once

#include <cstddef>

#include "ddtool/filter/occupancy_grid.hpp"
#include "graph/stretches.hpp"

namespace ddtool::merging {

/// How the walls of a window and of a map agree, counted both ways: walls that lie in ground which the other observed,
/// and of these the ones that lie on its walls. The rest contradict: one saw free space where the other has a wall.
struct WallAgreement {
    std::size_t known = 0;
    std::size_t agreed = 0;

    [[nodiscard]] std::size_t contradicted() const { return known - agreed; }
    [[nodiscard]] double share() const {
        return known == 0 ? 0.0 : static_cast<double>(agreed) / static_cast<double>(known);
    }
    WallAgreement& operator+=(const WallAgreement& other) {
        known += other.known;
        agreed += other.agreed;
        return *this;
    }
};

/// \param map_from_window the pose of the window's anchor in the map; both have cells of the same size
WallAgreement wall_agreement(const graph::StretchMap& window, const OccupancyGrid& map, const Pose2& map_from_window);

}  // namespace ddtool::merging

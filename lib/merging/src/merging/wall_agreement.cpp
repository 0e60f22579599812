#include "merging/wall_agreement.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "graph/loop_search.hpp"

namespace ddtool::merging {
namespace {

/// A wall lies on one of the other map if it is this near to it: twice a cell, the noise of both maps.
constexpr double on_wall_m = 0.1;

/// The cells of the map that the window reaches.
CellBox reach_of(const OccupancyGrid& window, const Pose2& map_from_window) {
    const double cell_m = window.cell_size_m();
    const CellBox box = window.observed_box();
    constexpr int most = std::numeric_limits<int>::max();
    CellBox reach{most, most, -most, -most};
    for (const auto& [x, y] :
         {std::pair{box.x_min, box.y_min}, {box.x_max, box.y_min}, {box.x_min, box.y_max}, {box.x_max, box.y_max}}) {
        const Point2 at = map_from_window * Point2{x * cell_m, y * cell_m};
        const int column = static_cast<int>(std::floor(at.x_m / cell_m));
        const int row = static_cast<int>(std::floor(at.y_m / cell_m));
        reach = {std::min(reach.x_min, column), std::min(reach.y_min, row), std::max(reach.x_max, column + 1),
                 std::max(reach.y_max, row + 1)};
    }
    return reach;
}

}  // namespace

WallAgreement wall_agreement(const graph::StretchMap& window, const OccupancyGrid& map, const Pose2& map_from_window) {
    const graph::Overlap forth = graph::overlap(window, map, map_from_window);
    WallAgreement both{forth.known, forth.agreed};
    const Pose2 window_from_map = inverse(map_from_window);
    const double cell_m = map.cell_size_m();
    constexpr double unit = 1.0 / NearestPoint::units_per_cell;
    map.visit_patches(reach_of(window.grid, map_from_window), [&](const Patch& patch, const CellBox& box) {
        for (int y = box.y_min; y < box.y_max; ++y) {
            for (int x = box.x_min; x < box.x_max; ++x) {
                const std::size_t local = Patch::local(x, y);
                if (patch.log_odds[local] <= 0) {
                    continue;
                }
                const NearestPoint mean = patch.nearest[local];
                const Point2 at =
                    window_from_map * Point2{(x + 0.5 + unit * mean.x) * cell_m, (y + 0.5 + unit * mean.y) * cell_m};
                const Cell cell{static_cast<int>(std::floor(at.x_m / cell_m)),
                                static_cast<int>(std::floor(at.y_m / cell_m))};
                const NearestPoint nearest = window.grid.nearest(cell);
                const bool near = !nearest.none() && cell_m * unit * std::hypot(nearest.x, nearest.y) <= on_wall_m;
                both.known += near || window.grid.log_odds(cell) != Patch::unknown ? 1 : 0;
                both.agreed += near ? 1 : 0;
            }
        }
    });
    return both;
}

}  // namespace ddtool::merging

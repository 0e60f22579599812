#include "localization/scan_fit.hpp"

#include <cmath>

namespace ddtool::localization {
namespace {

/// A point lies on a wall if it is this near to an occupied point: the reach of the map's field, less noise.
constexpr double on_wall_m = 0.1;

}  // namespace

ScanFit scan_fit(const ScanPoints& points, const OccupancyGrid& map, const Pose2& pose) {
    const double cell_m = map.cell_size_m();
    const double on_wall = on_wall_m / cell_m * NearestPoint::units_per_cell;
    const double c = std::cos(pose.theta_rad) / cell_m;
    const double s = std::sin(pose.theta_rad) / cell_m;
    ScanFit fit{.points = points.size()};
    for (std::size_t i = 0; i < points.size(); ++i) {
        const auto x = static_cast<double>(points.x_m[i]);
        const auto y = static_cast<double>(points.y_m[i]);
        const Cell cell{static_cast<int>(std::floor(pose.x_m / cell_m + c * x - s * y)),
                        static_cast<int>(std::floor(pose.y_m / cell_m + s * x + c * y))};
        const NearestPoint nearest = map.nearest(cell);
        const bool near = !nearest.none() && std::hypot(nearest.x, nearest.y) <= on_wall;
        fit.known += near || map.log_odds(cell) != Patch::unknown ? 1 : 0;
        fit.agreed += near ? 1 : 0;
    }
    return fit;
}

}  // namespace ddtool::localization

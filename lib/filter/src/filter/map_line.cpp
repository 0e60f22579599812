#include "ddtool/filter/map_line.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "base/squared.hpp"
#include "ddtool/robot/scan_points.hpp"

namespace ddtool {
namespace {

/// Not a setting: over longer distances a line runs round corners, and over shorter ones it has the direction of the
/// noise. It needs the two cells on either side in any case, the mean points of which lie farther away if cells are
/// large.
constexpr double reach_m = 0.08;
constexpr double least_reach_cells = 1.6;
constexpr int points_of_a_line = 3;

/// Sums over points, each of which counts `weight` times, in units of NearestPoint relative to one point. Whole numbers
/// are quicker to add up.
struct PointSums {
    std::int64_t weight = 0, x = 0, y = 0, xx = 0, xy = 0, yy = 0;

    void add(std::int64_t times, std::int64_t dx, std::int64_t dy) {
        weight += times;
        x += times * dx;
        y += times * dy;
        xx += times * dx * dx;
        xy += times * dx * dy;
        yy += times * dy * dy;
    }
};

/// The line through the points that were summed, relative to their origin.
MapLine line_of(const PointSums& sums) {
    const float each = 1.0F / static_cast<float>(sums.weight);
    const float x = each * static_cast<float>(sums.x);
    const float y = each * static_cast<float>(sums.y);
    const float xx = each * static_cast<float>(sums.xx) - x * x;
    const float xy = each * static_cast<float>(sums.xy) - x * y;
    const float yy = each * static_cast<float>(sums.yy) - y * y;
    const float mean = 0.5F * (xx + yy);
    const float half = 0.5F * (xx - yy);
    const float root = std::sqrt(half * half + xy * xy);
    constexpr auto flatness2 = static_cast<float>(squared(ScanPoints::line_flatness));
    if (!(root > 0.0F) || mean - root > flatness2 * (mean + root)) {
        return {};
    }
    // Half of the angle whose cosine is half / root and whose sine is xy / root is that of the line. Of its cosine and
    // sine the larger comes from the square root, the other by division.
    const float larger = std::sqrt(0.5F * (root + std::abs(half)) / root);
    const float smaller = 0.5F * xy / (root * larger);
    const bool along_x = half >= 0.0F;
    constexpr float unit = 1.0F / NearestPoint::units_per_cell;
    return {unit * x, unit * y, along_x ? -smaller : -larger, along_x ? larger : smaller};
}

}  // namespace

MapLineFit::MapLineFit(double cell_size_m) {
    const double reach_cells = std::max(reach_m / cell_size_m, least_reach_cells);
    radius_cells_ = static_cast<int>(std::ceil(reach_cells));
    radius2_ = static_cast<int>(squared(NearestPoint::units_per_cell * reach_cells));
}

MapLine MapLineFit::through(const OccupancyGrid& grid, Cell occupied) const {
    const NearestPoint centre = grid.nearest(occupied);
    PointSums sums;
    grid.visit_occupied({occupied.x - radius_cells_, occupied.y - radius_cells_, occupied.x + radius_cells_ + 1,
                         occupied.y + radius_cells_ + 1},
                        [&](Cell cell, std::int8_t log_odds, NearestPoint mean) {
                            const int x = NearestPoint::units_per_cell * (cell.x - occupied.x) + mean.x - centre.x;
                            const int y = NearestPoint::units_per_cell * (cell.y - occupied.y) + mean.y - centre.y;
                            if (x * x + y * y <= radius2_) {
                                sums.add(log_odds, x, y);
                            }
                        });
    return sums.weight < points_of_a_line * grid.settings().hit_step ? MapLine{} : line_of(sums);
}

MapLine KeptMapLines::through(const OccupancyGrid& grid, Cell occupied) {
    // The 64 cells of a stretch of a row lie side by side, and the stretches of all grids are spread over the places.
    // The first factor is 2^64 over the golden ratio, the others are large primes.
    const std::uint64_t stretch = grid.version() + 1000003 * static_cast<std::uint64_t>(occupied.y) +
                                  998244353 * static_cast<std::uint64_t>(occupied.x >> 6);
    const std::uint64_t place =
        ((stretch * 0x9e3779b97f4a7c15) >> (64 - size_bits)) ^ static_cast<std::uint64_t>(occupied.x & 63);
    Kept& kept = kept_[place & (kept_.size() - 1)];
    if (kept.version != grid.version() || !(kept.occupied == occupied)) {
        kept = {grid.version(), occupied, fit_.through(grid, occupied)};
    }
    return kept.line;
}

}  // namespace ddtool

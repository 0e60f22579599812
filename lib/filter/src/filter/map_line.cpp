#include "ddtool/filter/map_line.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>

#include "base/lanes.hpp"
#include "base/squared.hpp"
#include "ddtool/robot/scan_points.hpp"

namespace ddtool {
namespace {

/// Not a setting: over longer distances a line runs round corners, and over shorter ones it has the direction of the
/// noise. It needs the two cells on either side in any case, the mean points of which lie farther away if cells are
/// large.
constexpr double reach_m = 0.08;
constexpr double least_reach_cells = 1.6;
constexpr std::int64_t points_of_a_line = 3;

/// Sums over points, each of which counts `weight` times, in units of NearestPoint relative to one point.
struct PointSums {
    std::int64_t weight = 0, x = 0, y = 0, xx = 0, xy = 0, yy = 0;
};

/// The same, lane by lane. A lane has a number for every eighth column of the window, few enough not to overflow.
struct LaneSums {
    IntLanes weight{}, x{}, y{}, xx{}, xy{}, yy{};
};

std::int64_t total(const IntLanes& lanes) {
    std::int64_t sum = 0;
    for (std::size_t lane = 0; lane < lane_count; ++lane) {
        sum += lanes[lane];
    }
    return sum;
}

/// The window in which points are summed: the mean points that are seen from that of the occupied cell within a radius.
struct Window {
    Cell occupied;
    NearestPoint centre;
    int radius2;  ///< in units of NearestPoint, squared
};

/// Adds the occupied cells of a piece of one patch, which is at most lane_count cells wide. A whole set of lanes is
/// loaded from each row, which may begin to the left of the piece so that it does not reach beyond the row.
DDTOOL_VECTORISED void add_piece(const Patch& patch, const CellBox& piece, const Window& window, LaneSums& sums) {
    static_assert(std::endian::native == std::endian::little && sizeof(NearestPoint) == sizeof(std::int16_t));
    using Bytes = std::int8_t __attribute__((vector_size(lane_count)));
    using Shorts = std::int16_t __attribute__((vector_size(lane_count * sizeof(std::int16_t))));
    constexpr IntLanes lane{0, 1, 2, 3, 4, 5, 6, 7};
    constexpr int most_first = Patch::size_cells - static_cast<int>(lane_count);
    const int skipped = std::max(0, (piece.x_min & Patch::local_mask) - most_first);
    const int first_x = piece.x_min - skipped;
    const IntLanes inside = (lane >= skipped) & (lane < piece.x_max - first_x);
    const IntLanes from_x = NearestPoint::units_per_cell * (lane + (first_x - window.occupied.x)) - window.centre.x;
    for (int y = piece.y_min; y < piece.y_max; ++y) {
        const std::size_t local = Patch::local(first_x, y);
        Bytes odds;
        Shorts points;
        std::memcpy(&odds, patch.log_odds.data() + local, sizeof odds);
        std::memcpy(&points, patch.nearest.data() + local, sizeof points);
        const IntLanes weights = __builtin_convertvector(odds, IntLanes);
        const IntLanes dx = from_x + __builtin_convertvector((points << 8) >> 8, IntLanes);
        const IntLanes dy = __builtin_convertvector(points >> 8, IntLanes) +
                            (NearestPoint::units_per_cell * (y - window.occupied.y) - window.centre.y);
        const IntLanes counts = inside & (weights > 0) & (dx * dx + dy * dy <= window.radius2);
        const IntLanes w = weights & counts;
        const IntLanes wx = w * dx;
        const IntLanes wy = w * dy;
        sums.weight += w;
        sums.x += wx;
        sums.y += wy;
        sums.xx += wx * dx;
        sums.xy += wx * dy;
        sums.yy += wy * dy;
    }
}

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
    const Window window{occupied, grid.nearest(occupied), radius2_};
    LaneSums lanes;
    grid.visit_patches({occupied.x - radius_cells_, occupied.y - radius_cells_, occupied.x + radius_cells_ + 1,
                        occupied.y + radius_cells_ + 1},
                       [&](const Patch& patch, CellBox piece) {
                           constexpr int width = lane_count;
                           for (const int end = piece.x_max; piece.x_min < end; piece.x_min = piece.x_max) {
                               piece.x_max = std::min(end, piece.x_min + width);
                               add_piece(patch, piece, window, lanes);
                           }
                       });
    const PointSums sums{total(lanes.weight), total(lanes.x),  total(lanes.y),
                         total(lanes.xx),     total(lanes.xy), total(lanes.yy)};
    return sums.weight < points_of_a_line * grid.settings().hit_step ? MapLine{} : line_of(sums);
}

std::size_t KeptMapLines::place_of(const OccupancyGrid& grid, Cell occupied) {
    // The 64 cells of a stretch of a row lie side by side, and the stretches of all grids are spread over the places.
    // The first factor is 2^64 over the golden ratio, the others are large primes.
    const std::uint64_t stretch = grid.version() + 1000003 * static_cast<std::uint64_t>(occupied.y) +
                                  998244353 * static_cast<std::uint64_t>(occupied.x >> 6);
    const std::uint64_t place =
        ((stretch * 0x9e3779b97f4a7c15) >> (64 - size_bits)) ^ static_cast<std::uint64_t>(occupied.x & 63);
    return place & ((std::size_t{1} << size_bits) - 1);
}

MapLine KeptMapLines::through(const OccupancyGrid& grid, Cell occupied) {
    Kept& kept = kept_[place_of(grid, occupied)];
    if (kept.version != grid.version() || !(kept.occupied == occupied)) {
        kept = {grid.version(), occupied, fit_.through(grid, occupied)};
    }
    return kept.line;
}

}  // namespace ddtool

#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "ddtool/filter/patch_grid.hpp"
#include "ddtool/robot/pose2.hpp"

namespace ddtool {

/// A square of cells of a HitMap. Most cells have no hits and take four bytes.
struct HitPatch {
    static constexpr int size_bits = 4;
    static constexpr int size_cells = 1 << size_bits;
    static constexpr int local_mask = size_cells - 1;
    static constexpr std::size_t cell_count = static_cast<std::size_t>(size_cells) * size_cells;

    /// The end points that fell into one cell. The sums are single precision, as GMapping has them: to take its
    /// decisions, the means have to be rounded as its are.
    struct Hits {
        Point2 mean_m;
        float sum_x_m = 0.0F;
        float sum_y_m = 0.0F;
        std::uint32_t count = 0;
    };

    HitPatch() { MapBytes::live.fetch_add(sizeof(HitPatch), std::memory_order_relaxed); }
    HitPatch(const HitPatch& other) : hits(other.hits), slot(other.slot), around(other.around) {
        MapBytes::live.fetch_add(sizeof(HitPatch), std::memory_order_relaxed);
    }
    HitPatch& operator=(const HitPatch&) = delete;
    ~HitPatch() { MapBytes::live.fetch_sub(sizeof(HitPatch), std::memory_order_relaxed); }

    std::vector<Hits, CountedAllocator<Hits>> hits;  ///< of the cells that have some
    std::array<std::uint8_t, cell_count> slot{};     ///< where a cell that has hits finds them
    /// Which of the 3 x 3 cells about each cell have hits: bit 3 (dy + 1) + dx + 1 stands for the cell dx columns and
    /// dy rows away. Most cells that a bad pose asks for have none, which one look at this tells.
    std::array<std::uint16_t, cell_count> around{};
    std::atomic<std::uint32_t> owners = 1;
};

template <>
HitPatch* const CopyOnWrite<HitPatch>::empty_;

/// GMapping's map as its scan matching sees it: for every cell, the mean of all end points that fell into it. Nothing
/// is ever cleared, and free cells are not marked. A cell reaches half its size to each side of a multiple of the size,
/// in metres from the world's origin. Copies share their patches until one of them writes.
class HitMap {
public:
    explicit HitMap(double cell_size_m) : cells_per_m_(1.0 / cell_size_m) {}

    /// Makes room for end points within a box of the world. To be called before add(). Throws MapTooLarge if the map
    /// would have more than OccupancyGrid::most_patches.
    void reserve(Point2 low_m, Point2 high_m);
    /// Enters an end point.
    void add(Point2 end_m);

    /// The squared distance in m^2 from an end point to the nearest mean among those of its cell and the eight about
    /// it; negative if none of them has a hit.
    [[nodiscard]] double nearest_m2(Point2 end_m) const {
        const int x = cell_of(end_m.x_m);
        const int y = cell_of(end_m.y_m);
        const HitPatch& patch = patches_.at(x >> HitPatch::size_bits, y >> HitPatch::size_bits);
        unsigned around = patch.around[local(x, y)];
        double nearest = none_m2;
        for (; around != 0; around &= around - 1) {
            const int neighbour = std::countr_zero(around);
            const int column = x + neighbour % 3 - 1;
            const int row = y + neighbour / 3 - 1;
            const Point2 mean = hits_at(patch, x, y, column, row).mean_m;
            const double dx = end_m.x_m - mean.x_m;
            const double dy = end_m.y_m - mean.y_m;
            const double distance = dx * dx + dy * dy;
            nearest = nearest < 0.0 || distance < nearest ? distance : nearest;
        }
        return nearest;
    }

private:
    static constexpr double none_m2 = -1.0;
    static constexpr unsigned own_bit = 4;

    /// Rounds to the nearest whole number, and halves away from zero. Beyond most_cells there is one cell.
    [[nodiscard]] int cell_of(double along_m) const {
        const double cells = std::min(std::max(along_m * cells_per_m_, -most_cells), most_cells);
        return static_cast<int>(cells + std::copysign(0.5, cells));
    }
    static std::size_t local(int x, int y) {
        return static_cast<std::size_t>(y & HitPatch::local_mask) * HitPatch::size_cells +
               static_cast<std::size_t>(x & HitPatch::local_mask);
    }
    /// The hits of a cell, which is in `patch` if it has the same column and row of patches as the cell (x, y).
    [[nodiscard]] const HitPatch::Hits& hits_at(const HitPatch& patch, int x, int y, int column, int row) const {
        const bool same = ((x ^ column) | (y ^ row)) >> HitPatch::size_bits == 0;
        const HitPatch& holder = same ? patch : patches_.at(column >> HitPatch::size_bits, row >> HitPatch::size_bits);
        return holder.hits[holder.slot[local(column, row)]];
    }
    void mark(int x, int y);

    double cells_per_m_;
    PatchGrid<HitPatch> patches_;
};

}  // namespace ddtool

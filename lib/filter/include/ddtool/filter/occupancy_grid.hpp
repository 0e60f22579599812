#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>

#include "ddtool/base/error.hpp"
#include "ddtool/filter/patch.hpp"
#include "ddtool/robot/pose2.hpp"

namespace ddtool {

/// A cell of the grid. It covers [x, x+1) x [y, y+1), in cells from the world's origin.
struct Cell {
    int x = 0;
    int y = 0;

    bool operator==(const Cell&) const = default;
};

/// The cell in which a point lies that is seen from the centre of `cell`. This is exact: offsets within a cell are
/// whole numbers in -16..15, and the shift by 5 bits divides by NearestPoint::units_per_cell and rounds down.
inline Cell cell_of(NearestPoint point, Cell cell) {
    constexpr int half = NearestPoint::units_per_cell / 2;
    return {cell.x + ((point.x + half) >> 5), cell.y + ((point.y + half) >> 5)};
}

/// Largest distance of a cell from the world's origin along either axis, in cells. Cells beyond it have no number, and
/// no map reaches that far.
inline constexpr double most_cells = 1e9;

/// The cells with x in x_min..x_max-1 and y in y_min..y_max-1.
struct CellBox {
    int x_min = 0, y_min = 0, x_max = 0, y_max = 0;

    [[nodiscard]] bool empty() const { return x_min >= x_max || y_min >= y_max; }
};

/// Log odds are counted in whole steps: an observation of a cell as free subtracts free_step, a hit adds hit_step. A
/// cell therefore counts as occupied if the share of hits among its observations exceeds free_step / (hit_step +
/// free_step), as long as the log odds stay between their limits.
struct OccupancySettings {
    double cell_size_m = 0.05;
    int hit_step = 6;
    int free_step = 1;
    int min_log_odds = -30;
    int max_log_odds = 60;
    /// Limit in MiB on the memory of all maps of the process together, and of drawing the largest of them, beyond which
    /// no map grows; 0 means no limit.
    std::uint64_t most_memory_mib = 0;
};

/// Thrown when a map would grow beyond its limits. run_filter() then ends the run and returns the result so far.
class MapTooLarge : public Error {
public:
    using Error::Error;
};

/// Occupancy of the plane, stored in patches that copies of the grid share until one of them writes. It also holds the
/// field that scan matching reads: for every cell, the nearest occupied point within field_radius cells, where the
/// point of an occupied cell is the mean of the end points that fell into it. Every change updates the field around the
/// changed cell, so it is never built as a whole.
class OccupancyGrid {
public:
    static constexpr int field_radius = 3;
    static constexpr std::int64_t most_patches = std::int64_t{1} << 23;  ///< limit on a map's table of pointers: 64 MiB

    explicit OccupancyGrid(const OccupancySettings& settings);

    [[nodiscard]] const OccupancySettings& settings() const { return settings_; }
    [[nodiscard]] double cell_size_m() const { return settings_.cell_size_m; }

    /// Evidence in steps: above 0 for "occupied", otherwise for "free"; Patch::unknown where nothing was observed.
    [[nodiscard]] std::int8_t log_odds(Cell cell) const {
        return patch_at(cell).log_odds[Patch::local(cell.x, cell.y)];
    }
    [[nodiscard]] bool occupied(Cell cell) const { return log_odds(cell) > 0; }
    /// The nearest occupied point as seen from the cell's centre; none() where there is no such point in the field.
    [[nodiscard]] NearestPoint nearest(Cell cell) const { return patch_at(cell).nearest[Patch::local(cell.x, cell.y)]; }

    /// Has the processor fetch what nearest() reads, without waiting for it.
    void prefetch(Cell cell) const { __builtin_prefetch(&patch_at(cell).nearest[Patch::local(cell.x, cell.y)]); }

    /// Calls visit(patch, box) for the pieces of a box that lie in one patch each.
    template <typename Visit>
    void visit_patches(const CellBox& box, Visit&& visit) const {
        for (int top = box.y_min; top < box.y_max; top = Patch::next(top)) {
            for (int left = box.x_min; left < box.x_max; left = Patch::next(left)) {
                visit(patch_at({left, top}), CellBox{left, top, std::min(box.x_max, Patch::next(left)),
                                                     std::min(box.y_max, Patch::next(top))});
            }
        }
    }

    /// Makes room for writing to the box. It must be called before the functions below that write, for a box that holds
    /// the cells they write. Throws MapTooLarge if the memory that the settings allow might not suffice, or if the map
    /// would have more than most_patches, which is some square kilometres: no robot drives that far, but an odometry
    /// whose poses jump does.
    void reserve(const CellBox& box);
    /// Enters an end point in `cell`, at `offset` from the cell's centre.
    void add_hit(Cell cell, NearestPoint offset);
    /// Enters that beams passed through cells x_begin..x_end-1 of row y.
    void add_free(int y, int x_begin, int x_end);

    /// From now on the evidence for a wall fades where beams pass: each of them takes away the share of it that
    /// `half_life_scans` of them halve, beside free_step. What decides whether a cell is occupied, more hits or more
    /// passing beams, stays the same; how much must be passed before a wall of long ago is gone becomes less. 0: no
    /// more.
    void fade(int half_life_scans);

    /// Makes a cell what it is in another map: with this evidence, and if it is occupied, with the mean of its hits at
    /// `mean` from its centre, each coordinate in -16..15. reserve() must have been called for it.
    void set(Cell cell, std::int8_t log_odds, NearestPoint mean);
    /// A number that all grids of the process with this content share, and no other: copies have it until one of them
    /// is written to. It says whether something that was computed from a grid still holds.
    [[nodiscard]] std::uint64_t version() const { return version_; }

    /// The smallest box of whole patches that holds everything observed.
    [[nodiscard]] CellBox observed_box() const;

private:
    [[nodiscard]] const Patch& patch_at(Cell cell) const {
        const int column = (cell.x >> Patch::size_bits) - first_column_;
        const int row = (cell.y >> Patch::size_bits) - first_row_;
        if (static_cast<unsigned>(column) >= static_cast<unsigned>(columns_) ||
            static_cast<unsigned>(row) >= static_cast<unsigned>(rows_)) {
            return *unknown_;
        }
        return *patches_[patch_index(column, row)];
    }
    [[nodiscard]] std::size_t patch_index(int column, int row) const {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(column);
    }
    PatchPointer& pointer_at(Cell cell);
    void spread(Cell occupied_cell, NearestPoint offset);
    [[nodiscard]] bool lower(std::int8_t* cells, int length) const;
    void forget_freed(int y, int x_begin, int x_end);
    void forget(Cell freed_cell);
    [[nodiscard]] NearestPoint search_nearest(Cell cell) const;

    /// Any thread may take the next version.
    void change() { version_ = 1 + last_version_.fetch_add(1, std::memory_order_relaxed); }

    inline static std::atomic<std::uint64_t> last_version_ = 0;

    OccupancySettings settings_;
    std::uint64_t version_ = 0;
    int kept_of_256_ = 256;  ///< what a passing beam leaves of the evidence for a wall, ahead of free_step
    PatchPointer unknown_;
    int first_column_ = 0, first_row_ = 0, columns_ = 0, rows_ = 0;
    PatchTable patches_;
};

}  // namespace ddtool

#pragma once

#include <cstddef>
#include <cstdint>

#include "ddtool/base/error.hpp"
#include "ddtool/filter/patch.hpp"
#include "ddtool/robot/pose2.hpp"

namespace ddtool {

/// A cell of the grid: covers [x, x+1) x [y, y+1) in cells from the world's origin.
struct Cell {
    int x = 0;
    int y = 0;

    bool operator==(const Cell&) const = default;
};

/// Further from the world's origin than this cells have no number, and no map reaches.
inline constexpr double most_cells = 1e9;

/// Cells x_min..x_max-1, y_min..y_max-1.
struct CellBox {
    int x_min = 0, y_min = 0, x_max = 0, y_max = 0;

    [[nodiscard]] bool empty() const { return x_min >= x_max || y_min >= y_max; }
};

/// Log odds are kept in steps of one observed-free; what a hit is worth follows from the share of observations that
/// must be hits for a cell to count as occupied: free_step / (hit_step + free_step).
struct OccupancySettings {
    double cell_size_m = 0.05;
    int hit_step = 6;
    int free_step = 1;
    int min_log_odds = -30;
    int max_log_odds = 60;
    /// No map grows once all maps of the process together take so many MiB; 0: there is no limit.
    std::uint64_t most_memory_mib = 0;
};

/// A map would grow beyond what maps may take. run_filter() ends there, with what it has.
class MapTooLarge : public Error {
public:
    using Error::Error;
};

/// Occupancy of the plane in patches shared between copies until written, and with it the field that scan matching
/// reads: for every cell the nearest occupied point (the mean of the end points that fell into a cell) within
/// field_radius cells. The field is kept up to date cell by cell, so it never has to be built.
class OccupancyGrid {
public:
    static constexpr int field_radius = 3;
    static constexpr std::int64_t most_patches = std::int64_t{1} << 23;  ///< 64 MB of pointers

    explicit OccupancyGrid(const OccupancySettings& settings);

    [[nodiscard]] const OccupancySettings& settings() const { return settings_; }
    [[nodiscard]] double cell_size_m() const { return settings_.cell_size_m; }

    /// Steps of evidence for "occupied" above 0, for "free" below; Patch::unknown where nothing was observed.
    [[nodiscard]] std::int8_t log_odds(Cell cell) const {
        return patch_at(cell).log_odds[Patch::local(cell.x, cell.y)];
    }
    [[nodiscard]] bool occupied(Cell cell) const { return log_odds(cell) > 0; }
    [[nodiscard]] NearestPoint nearest(Cell cell) const { return patch_at(cell).nearest[Patch::local(cell.x, cell.y)]; }

    /// Makes room for writing to the box. Both functions below need it. Throws MapTooLarge where the memory that the
    /// settings allow may not do for it, and for a map of more than most_patches, some square kilometres: no robot
    /// drives so far, but an odometry that jumps does.
    void reserve(const CellBox& box);
    /// An end point in `cell`, at `offset` from its centre.
    void add_hit(Cell cell, NearestPoint offset);
    /// Cells x_begin..x_end-1 of a row were seen through.
    void add_free(int y, int x_begin, int x_end);

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

    OccupancySettings settings_;
    PatchPointer unknown_;
    int first_column_ = 0, first_row_ = 0, columns_ = 0, rows_ = 0;
    PatchTable patches_;
};

}  // namespace ddtool

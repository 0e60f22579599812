#include "ddtool/filter/occupancy_grid.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <utility>

#include "base/lanes.hpp"
#include "base/text.hpp"
#include "ddtool/base/error.hpp"

namespace ddtool {
namespace {

constexpr int units = NearestPoint::units_per_cell;

/// Converts the offset of a point from the centre of `from` to its offset from the centre of `to`.
NearestPoint moved(NearestPoint offset, Cell from, Cell to) {
    return {static_cast<std::int8_t>(offset.x + units * (from.x - to.x)),
            static_cast<std::int8_t>(offset.y + units * (from.y - to.y))};
}

int squared_length(NearestPoint point) { return point.x * point.x + point.y * point.y; }

NearestPoint running_mean(NearestPoint mean, NearestPoint added, float gain) {
    const auto updated = [gain](std::int8_t before, std::int8_t value) {
        return static_cast<std::int8_t>(
            std::lrintf(static_cast<float>(before) + gain * static_cast<float>(value - before)));
    };
    return {updated(mean.x, added.x), updated(mean.y, added.y)};
}

bool all_equal(const std::int8_t* cells, int length, int value) {
    int differences = 0;
    for (int i = 0; i < length; ++i) {
        differences |= cells[i] ^ value;
    }
    return differences == 0;
}

using Shorts = std::int16_t __attribute__((vector_size(Patch::size_cells * sizeof(std::int16_t))));
using Bytes = std::int8_t __attribute__((vector_size(Patch::size_cells)));

/// Updates the field in a piece of one patch: a cell gets the mean point of the occupied cell as its nearest point if
/// that is nearer than the present one, or if the present one is an older mean of the same cell. The cells of a row are
/// worked on side by side, as whole numbers of 16 bits; those outside of the piece are left as they are.
DDTOOL_VECTORISED void spread_in(Patch& patch, const CellBox& piece, Cell occupied_cell, NearestPoint offset) {
    static_assert(std::endian::native == std::endian::little && sizeof(NearestPoint) == sizeof(std::int16_t));
    constexpr Shorts lane{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15};
    constexpr Shorts ones = Shorts{} + std::int16_t{1};
    constexpr int half = units / 2;
    const auto first = static_cast<std::int16_t>(piece.x_min & Patch::local_mask);
    const auto end = static_cast<std::int16_t>(first + piece.x_max - piece.x_min);
    const Shorts inside = (lane >= first) & (lane < end);
    // How many columns the occupied cell is to the right. Outside of the piece the number may not fit.
    const Shorts right = (static_cast<std::int16_t>(occupied_cell.x - piece.x_min + first) - lane) & inside;
    const Shorts candidate_x = (right * static_cast<std::int16_t>(units) + static_cast<std::int16_t>(offset.x));
    for (int y = piece.y_min; y < piece.y_max; ++y) {
        NearestPoint* const row = patch.nearest.data() + Patch::local(0, y);
        const auto up = static_cast<std::int16_t>(occupied_cell.y - y);
        const auto candidate_y = static_cast<std::int16_t>(offset.y + units * up);
        Shorts present;
        Bytes odds;
        std::memcpy(&present, row, sizeof present);
        std::memcpy(&odds, patch.log_odds.data() + Patch::local(0, y), sizeof odds);
        const Shorts present_x = (present << 8) >> 8;
        const Shorts present_y = present >> 8;
        const Shorts candidate2 = candidate_x * candidate_x + static_cast<std::int16_t>(candidate_y * candidate_y);
        const Shorts present2 = present_x * present_x + present_y * present_y;
        // The nearest point of an occupied cell is always its own mean, because add_hit() reads the mean from there.
        const Shorts is_free = __builtin_convertvector(odds, Shorts) <= std::int16_t{0};
        const Shorts is_none = present_x == std::int16_t{NearestPoint::none_mark};
        const Shorts is_older =
            (((present_x + std::int16_t{half}) >> 5) == right) & (((present_y + std::int16_t{half}) >> 5) == up * ones);
        const Shorts change = inside & ((is_free & (candidate2 < present2)) | is_none | is_older);
        const Shorts candidate = (candidate_x & std::int16_t{0xff}) |
                                 static_cast<std::int16_t>(static_cast<std::uint16_t>(candidate_y) << 8);
        const Shorts result = (candidate & change) | (present & ~change);
        std::memcpy(static_cast<void*>(row), &result, sizeof result);
    }
}

template <class Visit>
void for_each_around(Cell centre, Visit&& visit) {
    for (int y = centre.y - OccupancyGrid::field_radius; y <= centre.y + OccupancyGrid::field_radius; ++y) {
        for (int x = centre.x - OccupancyGrid::field_radius; x <= centre.x + OccupancyGrid::field_radius; ++x) {
            visit(Cell{x, y});
        }
    }
}

}  // namespace

OccupancyGrid::OccupancyGrid(const OccupancySettings& settings) : settings_(settings) {}

namespace {

/// A range of columns or rows of patches: first..end-1.
struct PatchSpan {
    int first = 0;
    int end = 0;

    [[nodiscard]] std::int64_t size() const { return std::int64_t{end} - first; }
};

PatchSpan patches_about(int first_cell, int end_cell) {
    return {(first_cell - OccupancyGrid::field_radius) >> Patch::size_bits,
            ((end_cell + OccupancyGrid::field_radius) >> Patch::size_bits) + 1};
}

void expect_possible(std::int64_t columns, std::int64_t rows, double cell_size_m) {
    if (columns * rows > OccupancyGrid::most_patches) {
        const double patch_km = 1e-3 * cell_size_m * Patch::size_cells;
        throw MapTooLarge("a map of " + fixed_text(static_cast<double>(columns) * patch_km, 1) + " km by " +
                          fixed_text(static_cast<double>(rows) * patch_km, 1) +
                          " km: the poses jump; expected an odometry in metres that goes on from where it was");
    }
}

/// What drawing a map with a table of so many patches takes at the end of a run: a cell value and a grey per cell, of
/// all the area between the outermost cells, seen or not.
std::int64_t picture_bytes(std::int64_t patches) {
    constexpr auto cells = static_cast<std::int64_t>(Patch::cell_count);
    return 2 * cells * patches;
}

/// Throws MapTooLarge if the maps of the process would need more than most_mib with `more` additional bytes. 0 means no
/// limit.
void expect_memory(std::int64_t more, std::uint64_t most_mib) {
    constexpr int mib_bits = 20;
    if (most_mib > 0 && MapBytes::live.load(std::memory_order_relaxed) + static_cast<std::size_t>(more) >
                            static_cast<std::size_t>(most_mib) << mib_bits) {
        throw MapTooLarge("the maps do not fit into " + std::to_string(most_mib) +
                          " MiB; expected fewer particles, larger cells, or a larger filter.grid.most_memory_mib");
    }
}

}  // namespace

void OccupancyGrid::reserve(const CellBox& box) {
    const PatchSpan columns = patches_about(box.x_min, box.x_max);
    const PatchSpan rows = patches_about(box.y_min, box.y_max);
    // The worst case: all patches in the box are new or shared, and have to be allocated.
    const std::int64_t written = columns.size() * rows.size() * static_cast<std::int64_t>(sizeof(Patch));
    if (columns_ > 0 && columns.first >= first_column_ && rows.first >= first_row_ &&
        columns.end <= first_column_ + columns_ && rows.end <= first_row_ + rows_) {
        expect_memory(written + picture_bytes(std::int64_t{columns_} * rows_), settings_.most_memory_mib);
        return;
    }
    OccupancyGrid larger(settings_);
    larger.version_ = version_;
    larger.kept_of_256_ = kept_of_256_;
    const bool fresh = columns_ == 0;
    larger.first_column_ = fresh ? columns.first : std::min(columns.first, first_column_);
    larger.first_row_ = fresh ? rows.first : std::min(rows.first, first_row_);
    larger.columns_ = std::max(columns.end, fresh ? columns.end : first_column_ + columns_) - larger.first_column_;
    larger.rows_ = std::max(rows.end, fresh ? rows.end : first_row_ + rows_) - larger.first_row_;
    expect_possible(larger.columns_, larger.rows_, settings_.cell_size_m);
    const std::int64_t patches = std::int64_t{larger.columns_} * larger.rows_;
    expect_memory(written + patches * static_cast<std::int64_t>(sizeof(PatchPointer)) + picture_bytes(patches),
                  settings_.most_memory_mib);
    larger.patches_.resize(static_cast<std::size_t>(larger.columns_) * static_cast<std::size_t>(larger.rows_));
    for (int row = 0; row < rows_; ++row) {
        const auto source = patches_.begin() + static_cast<std::ptrdiff_t>(patch_index(0, row));
        const std::size_t target =
            larger.patch_index(first_column_ - larger.first_column_, first_row_ + row - larger.first_row_);
        std::move(source, source + columns_, larger.patches_.begin() + static_cast<std::ptrdiff_t>(target));
    }
    *this = std::move(larger);
}

PatchPointer& OccupancyGrid::pointer_at(Cell cell) {
    const int column = (cell.x >> Patch::size_bits) - first_column_;
    const int row = (cell.y >> Patch::size_bits) - first_row_;
    return patches_[patch_index(column, row)];
}

/// If the log odds have reached their upper limit, a hit does not change them. They are then not written, so that the
/// patch can stay shared with other particles.
void OccupancyGrid::add_hit(Cell cell, NearestPoint offset) {
    change();
    PatchPointer& patch = pointer_at(cell);
    const std::size_t local = Patch::local(cell.x, cell.y);
    const std::int8_t present = patch->log_odds[local];
    const int before = present == Patch::unknown ? 0 : present;
    const int after = std::min(before + settings_.hit_step, settings_.max_log_odds);
    if (after != present) {
        patch.writable().log_odds[local] = static_cast<std::int8_t>(after);
    }
    if (after <= 0) {
        return;
    }
    if (before > 0) {
        // The number of earlier hits is not stored; the log odds collected so far stand in for it.
        const NearestPoint mean = patch->nearest[local];
        offset = running_mean(mean, offset,
                              static_cast<float>(settings_.hit_step) / static_cast<float>(before + settings_.hit_step));
        if (offset == mean) {
            return;
        }
    }
    spread(cell, offset);
}

void OccupancyGrid::set(Cell cell, std::int8_t log_odds, NearestPoint mean) {
    change();
    const bool was_occupied = occupied(cell);
    if (log_odds == this->log_odds(cell) && log_odds <= 0) {
        return;
    }
    pointer_at(cell).writable().log_odds[Patch::local(cell.x, cell.y)] = log_odds;
    if (log_odds > 0) {
        spread(cell, mean);
    } else if (was_occupied) {
        forget(cell);
    }
}

/// Works patch by patch for speed, because it runs for every end point that moves the mean of its cell.
void OccupancyGrid::spread(Cell occupied_cell, NearestPoint offset) {
    const int x_end = occupied_cell.x + field_radius + 1;
    const int y_end = occupied_cell.y + field_radius + 1;
    for (int y = occupied_cell.y - field_radius; y < y_end; y = Patch::next(y)) {
        for (int x = occupied_cell.x - field_radius; x < x_end; x = Patch::next(x)) {
            const CellBox piece{x, y, std::min(x_end, Patch::next(x)), std::min(y_end, Patch::next(y))};
            spread_in(pointer_at({x, y}).writable(), piece, occupied_cell, offset);
        }
    }
    pointer_at(occupied_cell).writable().nearest[Patch::local(occupied_cell.x, occupied_cell.y)] = offset;
}

void OccupancyGrid::add_free(int y, int x_begin, int x_end) {
    change();
    for (int x = x_begin; x < x_end;) {
        const int piece_end = std::min(x_end, Patch::next(x));
        const int length = piece_end - x;
        PatchPointer& patch = pointer_at({x, y});
        const std::size_t local = Patch::local(x, y);
        if (!all_equal(patch->log_odds.data() + local, length, settings_.min_log_odds) &&
            lower(patch.writable().log_odds.data() + local, length)) {
            forget_freed(y, x, piece_end);
        }
        x = piece_end;
    }
}

void OccupancyGrid::fade(int half_life_scans) {
    kept_of_256_ =
        half_life_scans <= 0 ? 256 : static_cast<int>(std::lround(256.0 * std::exp2(-1.0 / half_life_scans)));
}

/// Lowers the log odds of a run of cells by one observation as free. Returns whether one of the cells was occupied.
bool OccupancyGrid::lower(std::int8_t* cells, int length) const {
    const auto step = static_cast<std::int8_t>(settings_.free_step);
    const auto floor = static_cast<std::int8_t>(settings_.min_log_odds);
    int was_occupied = 0;
    if (kept_of_256_ < 256) {
        for (int i = 0; i < length; ++i) {
            if (cells[i] > 0) {  // rounded up, so that weak evidence fades by free_step alone
                cells[i] = static_cast<std::int8_t>((cells[i] * kept_of_256_ + 255) >> 8);
            }
        }
    }
    for (int i = 0; i < length; ++i) {
        const std::int8_t value = cells[i];
        was_occupied |= static_cast<int>(value > 0);
        const auto known = static_cast<std::int8_t>(value == Patch::unknown ? 0 : value);
        cells[i] = std::max(floor, static_cast<std::int8_t>(known - step));
    }
    return was_occupied != 0;
}

/// Removes the points of those cells of a row from the field that are no longer occupied.
void OccupancyGrid::forget_freed(int y, int x_begin, int x_end) {
    for (int x = x_begin; x < x_end; ++x) {
        if (!occupied({x, y}) && cell_of(nearest({x, y}), {x, y}) == Cell{x, y}) {
            forget({x, y});
        }
    }
}

void OccupancyGrid::forget(Cell freed_cell) {
    for_each_around(freed_cell, [&](Cell cell) {
        if (!nearest(cell).none() && cell_of(nearest(cell), cell) == freed_cell) {
            const NearestPoint next = search_nearest(cell);
            pointer_at(cell).writable().nearest[Patch::local(cell.x, cell.y)] = next;
        }
    });
}

NearestPoint OccupancyGrid::search_nearest(Cell cell) const {
    NearestPoint best;
    for_each_around(cell, [&](Cell other) {
        if (occupied(other)) {
            const NearestPoint candidate = moved(nearest(other), other, cell);
            if (best.none() || squared_length(candidate) < squared_length(best)) {
                best = candidate;
            }
        }
    });
    return best;
}

CellBox OccupancyGrid::observed_box() const {
    int left = columns_;
    int right = 0;
    int bottom = rows_;
    int top = 0;
    for (int row = 0; row < rows_; ++row) {
        for (int column = 0; column < columns_; ++column) {
            if (!patches_[patch_index(column, row)].empty()) {
                left = std::min(left, column);
                right = std::max(right, column + 1);
                bottom = std::min(bottom, row);
                top = std::max(top, row + 1);
            }
        }
    }
    if (left >= right) {
        return {};
    }
    const auto cells = [](int patches) { return patches * Patch::size_cells; };
    return {cells(first_column_ + left), cells(first_row_ + bottom), cells(first_column_ + right),
            cells(first_row_ + top)};
}

}  // namespace ddtool

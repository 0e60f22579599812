#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "ddtool/filter/copy_on_write.hpp"
#include "ddtool/filter/occupancy_grid.hpp"
#include "ddtool/filter/patch.hpp"

namespace ddtool {

/// The patches of a map that grows, row by row. Copies share patches until one of them writes.
template <typename Content>
class PatchGrid {
public:
    /// The patch with this column and row; the empty one outside the grid.
    [[nodiscard]] const Content& at(int column, int row) const {
        return holds(column, row) ? *patches_[index(column, row)] : *empty_;
    }
    /// The patch for writing. The grid must have room for it.
    Content& writable(int column, int row) { return patches_[index(column, row)].writable(); }

    /// Makes room for columns first_column..end_column-1 and rows first_row..end_row-1. Throws MapTooLarge if the grid
    /// would have more than OccupancyGrid::most_patches.
    void reserve(int first_column, int first_row, int end_column, int end_row) {
        if (holds(first_column, first_row) && holds(end_column - 1, end_row - 1)) {
            return;
        }
        const bool fresh = columns_ == 0;
        PatchGrid larger;
        larger.first_column_ = fresh ? first_column : std::min(first_column, first_column_);
        larger.first_row_ = fresh ? first_row : std::min(first_row, first_row_);
        larger.columns_ = (fresh ? end_column : std::max(end_column, first_column_ + columns_)) - larger.first_column_;
        larger.rows_ = (fresh ? end_row : std::max(end_row, first_row_ + rows_)) - larger.first_row_;
        if (std::int64_t{larger.columns_} * larger.rows_ > OccupancyGrid::most_patches) {
            throw MapTooLarge("a map of " + std::to_string(larger.columns_) + " by " + std::to_string(larger.rows_) +
                              " patches: the poses jump or ranges are too long; expected both in metres");
        }
        larger.patches_.resize(static_cast<std::size_t>(larger.columns_) * static_cast<std::size_t>(larger.rows_));
        for (int row = first_row_; row < first_row_ + rows_; ++row) {
            for (int column = first_column_; column < first_column_ + columns_; ++column) {
                larger.patches_[larger.index(column, row)] = std::move(patches_[index(column, row)]);
            }
        }
        *this = std::move(larger);
    }

private:
    [[nodiscard]] bool holds(int column, int row) const {
        return static_cast<unsigned>(column - first_column_) < static_cast<unsigned>(columns_) &&
               static_cast<unsigned>(row - first_row_) < static_cast<unsigned>(rows_);
    }
    [[nodiscard]] std::size_t index(int column, int row) const {
        return static_cast<std::size_t>(row - first_row_) * static_cast<std::size_t>(columns_) +
               static_cast<std::size_t>(column - first_column_);
    }

    CopyOnWrite<Content> empty_;
    int first_column_ = 0, first_row_ = 0, columns_ = 0, rows_ = 0;
    std::vector<CopyOnWrite<Content>, CountedAllocator<CopyOnWrite<Content>>> patches_;
};

}  // namespace ddtool

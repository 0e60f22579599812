#pragma once

#include <cstddef>

namespace ddtool::network {

/// Rows of scores in memory. The first `columns` of each row are scores; the rest up to row_step, a multiple of
/// lane_count, may be overwritten.
struct ScoreRows {
    float* scores = nullptr;
    std::size_t rows = 0;
    std::size_t columns = 0;
    std::size_t row_step = 0;
};

/// Replaces every row by the softmax of `scale` times the row; `scale` must be above 0.
void apply_softmax(const ScoreRows& matrix, float scale);

}  // namespace ddtool::network

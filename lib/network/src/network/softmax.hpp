#pragma once

#include <cstddef>

namespace ddtool::native {

/// Rows of scores in memory: of each, `columns` count; the rest up to row_step, a multiple of lane_count, is scratch.
struct ScoreRows {
    float* scores = nullptr;
    std::size_t rows = 0;
    std::size_t columns = 0;
    std::size_t row_step = 0;
};

/// Every row becomes the softmax of `scale` > 0 times itself.
void apply_softmax(const ScoreRows& matrix, float scale);

}  // namespace ddtool::native

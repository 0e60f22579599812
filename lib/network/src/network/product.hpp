#pragma once

#include <cstddef>
#include <span>

#include "base/lanes.hpp"

namespace ddtool::native {

/// Outputs are worked on in blocks of so many; every number of outputs is a multiple of it.
inline constexpr std::size_t block_width = 2 * lane_count;

/// The inputs that a point sees: `rows` runs of `length` neighbours, whose starts lie `row_step` apart.
struct Window {
    std::size_t rows = 1;
    std::size_t length = 0;
    std::size_t row_step = 0;
    [[nodiscard]] std::size_t inputs() const { return rows * length; }
};

/// Weights in blocks of block_width outputs; of each block block_width weights for every input of the window.
struct WeightBlocks {
    const float* first = nullptr;
    std::size_t input_step = block_width;  ///< from the weights of one input to the next's, in floats
    std::size_t block_step = 0;            ///< from the weights of one block to the next's, in floats
};

/// The same weighted sums at many points: out[to[p] + o] = bias[o] + sum_i weight(i, o) * (input i of p's window).
/// It is convolutions, linear layers and the products of attention at once.
struct Product {
    const float* in = nullptr;
    std::span<const std::size_t> from;  ///< where each point's window starts in `in`
    Window window;
    WeightBlocks weights;
    std::size_t outputs = 0;
    const float* bias = nullptr;  ///< [outputs]; null: zeros
    const float* skip = nullptr;  ///< added to the result, laid out as `out`; null: none. Never `out` itself.
    bool relu = false;            ///< last of all
    float* out = nullptr;
    std::span<const std::size_t> to;  ///< as many as `from`
};

/// Sums run over the inputs in order, one lane for each output: the same bytes on every processor.
void multiply(const Product& product);

/// What `multiply` is made of: the first for processors with AVX-512, the second for all others. Each gives the right
/// sums on any processor; the first takes its time where it does not belong.
void multiply_in_wide_lanes(const Product& product);
void multiply_in_lanes(const Product& product);

}  // namespace ddtool::native

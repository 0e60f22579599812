#pragma once

#include <cstddef>
#include <span>

#include "base/lanes.hpp"

namespace ddtool::network {

/// Outputs are computed in blocks of this many; every number of outputs must be a multiple of it.
inline constexpr std::size_t block_width = 2 * lane_count;

/// The inputs that a point uses: `rows` runs of `length` neighbours, whose starts are `row_step` floats apart.
struct Window {
    std::size_t rows = 1;
    std::size_t length = 0;
    std::size_t row_step = 0;
    [[nodiscard]] std::size_t inputs() const { return rows * length; }
};

/// Weights in blocks of block_width outputs. A block holds block_width weights for every input of the window.
struct WeightBlocks {
    const float* first = nullptr;
    std::size_t input_step = block_width;  ///< from the weights of one input to the next's, in floats
    std::size_t block_step = 0;            ///< from the weights of one block to the next's, in floats
};

/// The same weighted sums at many points: out[to[p] + o] = bias[o] + sum_i weight(i, o) * (input i of p's window).
/// Convolutions, linear layers and the products of attention are all computed in this form.
struct Product {
    const float* in = nullptr;
    std::span<const std::size_t> from;  ///< where each point's window starts in `in`
    Window window;
    WeightBlocks weights;
    std::size_t outputs = 0;
    const float* bias = nullptr;  ///< [outputs]; null: zeros
    const float* skip = nullptr;  ///< added to the result, laid out as `out`; null: none. Never `out` itself.
    bool relu = false;            ///< applied last
    float* out = nullptr;
    std::span<const std::size_t> to;  ///< where each point's outputs start in `out`; as many as `from`
};

/// Computes the product. Each sum is formed in the order of the inputs, in one lane per output, so the result is the
/// same, byte for byte, on every processor.
void multiply(const Product& product);

/// The two implementations of multiply(): the first for processors with AVX-512, the second for all others. Both give
/// the right sums on any processor, but the first is slow without AVX-512.
void multiply_in_wide_lanes(const Product& product);
void multiply_in_lanes(const Product& product);

}  // namespace ddtool::network

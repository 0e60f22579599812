#include "native/product.hpp"

#include <algorithm>

namespace ddtool::native {
namespace {

/// Points worked on together, so that a weight loaded once serves them all. With two vectors of outputs each, their
/// sums take 12 of the 16 vector registers; four points were 5 to 12 % slower.
constexpr std::size_t tile_points = 6;

struct Tile {
    const float* in[tile_points];
    std::size_t to[tile_points];
    Lanes sums[tile_points][2];
};

/// The last tile repeats the last point instead of being shorter.
inline __attribute__((always_inline)) void place(const Product& p, std::size_t first, Tile& tile) {
    for (std::size_t i = 0; i < tile_points; ++i) {
        const std::size_t point = std::min(first + i, p.from.size() - 1);
        tile.in[i] = p.in + p.from[point];
        tile.to[i] = p.to[point];
    }
}

inline __attribute__((always_inline)) void add_inputs(const Window& window, const float* weight, std::size_t input_step,
                                                      Tile& tile) {
    for (std::size_t row = 0; row < window.rows; ++row) {
        for (std::size_t k = 0; k < window.length; ++k) {
            Lanes low;
            Lanes high;
            load(low, weight);
            load(high, weight + lane_count);
            weight += input_step;
            for (std::size_t i = 0; i < tile_points; ++i) {
                const float input = tile.in[i][row * window.row_step + k];
                tile.sums[i][0] += input * low;
                tile.sums[i][1] += input * high;
            }
        }
    }
}

inline __attribute__((always_inline)) void finish(const Product& p, std::size_t place, Lanes& sum) {
    if (p.skip != nullptr) {
        Lanes skip;
        load(skip, p.skip + place);
        sum += skip;
    }
    if (p.relu) {
        const Lanes zero{};
        sum = sum > zero ? sum : zero;
    }
    store(p.out + place, sum);
}

inline __attribute__((always_inline)) void multiply_tile(const Product& p, std::size_t output, const float* weight,
                                                         Tile& tile) {
    Lanes bias[2] = {};
    if (p.bias != nullptr) {
        load(bias[0], p.bias + output);
        load(bias[1], p.bias + output + lane_count);
    }
    for (auto& sums : tile.sums) {
        sums[0] = bias[0];
        sums[1] = bias[1];
    }
    add_inputs(p.window, weight, p.weights.input_step, tile);
    for (std::size_t i = 0; i < tile_points; ++i) {
        finish(p, tile.to[i] + output, tile.sums[i][0]);
        finish(p, tile.to[i] + output + lane_count, tile.sums[i][1]);
    }
}

}  // namespace

DDTOOL_VECTORISED void multiply(const Product& product) {
    const float* weight = product.weights.first;
    for (std::size_t output = 0; output < product.outputs; output += block_width) {
        for (std::size_t point = 0; point < product.from.size(); point += tile_points) {
            Tile tile;
            place(product, point, tile);
            multiply_tile(product, output, weight, tile);
        }
        weight += product.weights.block_step;
    }
}

}  // namespace ddtool::native

#include "network/product.hpp"

#include <algorithm>

namespace ddtool::network {
namespace {

using WideLanes = float __attribute__((vector_size(block_width * sizeof(float))));

template <typename Vector>
inline constexpr std::size_t vector_width = sizeof(Vector) / sizeof(float);

/// The points that are computed together, so that each weight is loaded once for all of them.
template <typename Vector, std::size_t points>
struct Tile {
    static constexpr std::size_t vectors = block_width / vector_width<Vector>;
    const float* in[points];
    std::size_t to[points];
    Vector sums[points][vectors];
};

/// Sets up the tile that begins at point `first`. If fewer points are left, the last point is computed several times,
/// which gives the same result and needs no code for shorter tiles.
template <typename Vector, std::size_t points>
inline __attribute__((always_inline)) void place(const Product& p, std::size_t first, Tile<Vector, points>& tile) {
    for (std::size_t i = 0; i < points; ++i) {
        const std::size_t point = std::min(first + i, p.from.size() - 1);
        tile.in[i] = p.in + p.from[point];
        tile.to[i] = p.to[point];
    }
}

template <typename Vector, std::size_t points>
inline __attribute__((always_inline)) void add_inputs(const Window& window, const float* weight, std::size_t input_step,
                                                      Tile<Vector, points>& tile) {
    for (std::size_t row = 0; row < window.rows; ++row) {
        for (std::size_t k = 0; k < window.length; ++k) {
            Vector weights[tile.vectors];
            for (std::size_t v = 0; v < tile.vectors; ++v) {
                load(weights[v], weight + v * vector_width<Vector>);
            }
            weight += input_step;
            for (std::size_t i = 0; i < points; ++i) {
                const float input = tile.in[i][row * window.row_step + k];
                for (std::size_t v = 0; v < tile.vectors; ++v) {
                    tile.sums[i][v] += input * weights[v];
                }
            }
        }
    }
}

template <typename Vector>
inline __attribute__((always_inline)) void finish(const Product& p, std::size_t place, Vector& sum) {
    if (p.skip != nullptr) {
        Vector skip;
        load(skip, p.skip + place);
        sum += skip;
    }
    if (p.relu) {
        const Vector zero{};
        sum = sum > zero ? sum : zero;
    }
    store(p.out + place, sum);
}

template <typename Vector, std::size_t points>
inline __attribute__((always_inline)) void multiply_tile(const Product& p, std::size_t output, const float* weight,
                                                         Tile<Vector, points>& tile) {
    for (std::size_t v = 0; v < tile.vectors; ++v) {
        Vector bias{};
        if (p.bias != nullptr) {
            load(bias, p.bias + output + v * vector_width<Vector>);
        }
        for (auto& sums : tile.sums) {
            sums[v] = bias;
        }
    }
    add_inputs(p.window, weight, p.weights.input_step, tile);
    for (std::size_t i = 0; i < points; ++i) {
        for (std::size_t v = 0; v < tile.vectors; ++v) {
            finish(p, tile.to[i] + output + v * vector_width<Vector>, tile.sums[i][v]);
        }
    }
}

template <typename Vector, std::size_t points>
inline __attribute__((always_inline)) void multiply_in_tiles(const Product& product) {
    const float* weight = product.weights.first;
    for (std::size_t output = 0; output < product.outputs; output += block_width) {
        for (std::size_t point = 0; point < product.from.size(); point += points) {
            Tile<Vector, points> tile;
            place(product, point, tile);
            multiply_tile(product, output, weight, tile);
        }
        weight += product.weights.block_step;
    }
}

}  // namespace

/// With two vectors of outputs each, the sums of six points take 12 of the 16 vector registers. Tiles of four points
/// were 5 to 12 % slower.
DDTOOL_VECTORISED void multiply_in_lanes(const Product& product) { multiply_in_tiles<Lanes, 6>(product); }

/// With AVX-512, one register holds a whole block. Without it, the compiler splits such a vector into slow code, so on
/// other processors only tests call this function. The 49, 196 and 784 places of the maps of images of 224 px are
/// multiples of the tile's seven points.
DDTOOL_VECTORISED_WIDE void multiply_in_wide_lanes(const Product& product) { multiply_in_tiles<WideLanes, 7>(product); }

void multiply(const Product& product) {
    static const bool wide = has_wide_registers();
    wide ? multiply_in_wide_lanes(product) : multiply_in_lanes(product);
}

}  // namespace ddtool::network

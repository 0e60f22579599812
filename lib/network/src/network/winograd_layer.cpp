#include "network/winograd_layer.hpp"

#include "base/lanes.hpp"
#include "network/affine_layer.hpp"
#include "network/weight_blocks.hpp"

namespace ddtool::network {
namespace {

/// A tile computes 4x4 outputs from 6x6 inputs: F(4x4, 3x3) of Lavin and Gray 2016, whose matrices are A, B and G.
constexpr std::size_t outputs_side = 4;
constexpr std::size_t inputs_side = 6;
constexpr std::size_t inputs_area = inputs_side * inputs_side;

/// One element of the transformed kernel G g G^T, where g is a 3x3 kernel.
float transformed(const float* kernel, std::size_t place) {
    constexpr double g[inputs_side][3] = {
        {1.0 / 4, 0.0, 0.0},           {-1.0 / 6, -1.0 / 6, -1.0 / 6}, {-1.0 / 6, 1.0 / 6, -1.0 / 6},
        {1.0 / 24, 1.0 / 12, 1.0 / 6}, {1.0 / 24, -1.0 / 12, 1.0 / 6}, {0.0, 0.0, 1.0}};
    double sum = 0.0;
    for (std::size_t tap = 0; tap < 9; ++tap) {
        sum += g[place / inputs_side][tap / 3] * kernel[tap] * g[place % inputs_side][tap % 3];
    }
    return static_cast<float>(sum);
}

/// The transformed kernels as 36 WeightBlocks, one for each place of a tile.
Floats packed_transforms(const FoldedKernel& kernel, std::size_t inputs) {
    const std::size_t outputs = kernel.bias.size();
    Floats packed;
    for (std::size_t place = 0; place < inputs_area; ++place) {
        const Floats blocks = packed_weights(outputs, inputs, [&](std::size_t output, std::size_t input) {
            return transformed(kernel.values.data() + (output * inputs + input) * 9, place);
        });
        packed.insert(packed.end(), blocks.begin(), blocks.end());
    }
    return packed;
}

/// Multiplies six values, which lie `step` apart, by B^T in place.
inline __attribute__((always_inline)) void transform_inputs(Lanes* values, std::size_t step) {
    const Lanes v1 = values[step];
    const Lanes v2 = values[2 * step];
    const Lanes v3 = values[3 * step];
    const Lanes v4 = values[4 * step];
    const Lanes even = v4 - 4.0F * v2;
    const Lanes odd = v3 - 4.0F * v1;
    const Lanes even_half = v4 - v2;
    const Lanes odd_half = 2.0F * (v3 - v1);
    values[0] = 4.0F * values[0] - 5.0F * v2 + v4;
    values[step] = even + odd;
    values[2 * step] = even - odd;
    values[3 * step] = even_half + odd_half;
    values[4 * step] = even_half - odd_half;
    values[5 * step] += 4.0F * v1 - 5.0F * v3;
}

/// Multiplies six values, which lie `step` apart, by A^T. The four results replace the first four values.
inline __attribute__((always_inline)) void transform_products(Lanes* values, std::size_t step) {
    const Lanes sum = values[step] + values[2 * step];
    const Lanes difference = values[step] - values[2 * step];
    const Lanes outer_sum = values[3 * step] + values[4 * step];
    const Lanes outer_difference = values[3 * step] - values[4 * step];
    values[0] += sum + outer_sum;
    values[step] = difference + 2.0F * outer_difference;
    values[2 * step] = sum + 4.0F * outer_sum;
    values[3 * step] = difference + 8.0F * outer_difference + values[5 * step];
}

/// Transforms the inputs of one tile, for all channels. The results of the 36 places are written `plane` floats apart.
inline __attribute__((always_inline)) void transform_tile(const float* in, const MapShape& shape, float* out,
                                                          std::size_t plane) {
    for (std::size_t channel = 0; channel < shape.channels; channel += lane_count) {
        Lanes values[inputs_area];
        for (std::size_t place = 0; place < inputs_area; ++place) {
            load(values[place],
                 in + place / inputs_side * shape.row_step() + place % inputs_side * shape.channels + channel);
        }
        for (std::size_t i = 0; i < inputs_side; ++i) {
            transform_inputs(values + i * inputs_side, 1);
        }
        for (std::size_t i = 0; i < inputs_side; ++i) {
            transform_inputs(values + i, inputs_side);
        }
        for (std::size_t place = 0; place < inputs_area; ++place) {
            store(out + place * plane + channel, values[place]);
        }
    }
}

DDTOOL_VECTORISED void transform_map(const float* in, const MapShape& shape, Floats& out) {
    const std::size_t plane = out.size() / inputs_area;
    float* tile = out.data();
    for (std::size_t y = 0; y < shape.side; y += outputs_side) {
        for (std::size_t x = 0; x < shape.side; x += outputs_side) {
            transform_tile(in + shape.at(y, x) - shape.row_step() - shape.channels, shape, tile, plane);
            tile += shape.channels;
        }
    }
}

struct Finish {
    const float* bias;
    const float* skip;  ///< null if nothing is added
    bool relu;
};

inline __attribute__((always_inline)) void finish(const Finish& how, std::size_t place, std::size_t channel,
                                                  const Lanes& product, float* out) {
    Lanes sum;
    load(sum, how.bias + channel);
    sum += product;
    if (how.skip != nullptr) {
        Lanes skip;
        load(skip, how.skip + place);
        sum += skip;
    }
    const Lanes zero{};
    store(out + place, how.relu ? (sum > zero ? sum : zero) : sum);
}

/// Transforms the products of one tile back, for all channels, and finishes its outputs. The products of the 36 places
/// lie `plane` floats apart; `corner` is the offset of the tile's first output.
inline __attribute__((always_inline)) void finish_tile(const float* products, std::size_t plane, const MapShape& shape,
                                                       const Finish& how, std::size_t corner, float* out) {
    for (std::size_t channel = 0; channel < shape.channels; channel += lane_count) {
        Lanes values[inputs_area];
        for (std::size_t place = 0; place < inputs_area; ++place) {
            load(values[place], products + place * plane + channel);
        }
        for (std::size_t i = 0; i < inputs_side; ++i) {
            transform_products(values + i, inputs_side);
        }
        for (std::size_t y = 0; y < outputs_side; ++y) {
            transform_products(values + y * inputs_side, 1);
            for (std::size_t x = 0; x < outputs_side; ++x) {
                finish(how, corner + y * shape.row_step() + x * shape.channels + channel, channel,
                       values[y * inputs_side + x], out);
            }
        }
    }
}

DDTOOL_VECTORISED void finish_map(const Floats& products, const MapShape& shape, const Finish& how, float* out) {
    const std::size_t plane = products.size() / inputs_area;
    const float* tile = products.data();
    for (std::size_t y = 0; y < shape.side; y += outputs_side) {
        for (std::size_t x = 0; x < shape.side; x += outputs_side) {
            finish_tile(tile, plane, shape, how, shape.at(y, x), out);
            tile += shape.channels;
        }
    }
}

std::size_t tiles_of(const MapShape& shape) { return shape.side * shape.side / (outputs_side * outputs_side); }

}  // namespace

WinogradLayer::WinogradLayer(const MapShape& in, FoldedKernel kernel, bool relu)
    : in_shape_(in),
      out_shape_{in.side, kernel.bias.size()},
      sources_(packed_tokens(tiles_of(in), in.channels)),
      targets_(packed_tokens(tiles_of(in), out_shape_.channels)),
      kernel_(packed_transforms(kernel, in.channels)),
      bias_(std::move(kernel.bias)),
      relu_(relu),
      inputs_(inputs_area * tiles_of(in) * in.channels),
      products_(inputs_area * tiles_of(in) * out_shape_.channels),
      out_(out_shape_.size(), 0.0F) {}

const float* WinogradLayer::run(const float* in, const float* skip) {
    transform_map(in, in_shape_, inputs_);
    for (std::size_t place = 0; place < inputs_area; ++place) {
        multiply({.in = inputs_.data() + place * inputs_.size() / inputs_area,
                  .from = sources_,
                  .window = {.length = in_shape_.channels},
                  .weights = {.first = kernel_.data() + place * kernel_.size() / inputs_area,
                              .block_step = in_shape_.channels * block_width},
                  .outputs = out_shape_.channels,
                  .out = products_.data() + place * products_.size() / inputs_area,
                  .to = targets_});
    }
    finish_map(products_, out_shape_, {bias_.data(), skip, relu_}, out_.data());
    return out_.data();
}

}  // namespace ddtool::network

#include "native/affine_layer.hpp"

#include <cmath>

namespace ddtool::native {
namespace {

constexpr double batch_norm_epsilon = 1e-5;

/// weight_of(output, input) in the order of WeightBlocks.
template <typename WeightOf>
Floats packed(std::size_t outputs, std::size_t inputs, const WeightOf& weight_of) {
    Floats blocks(outputs * inputs);
    for (std::size_t output = 0; output < outputs; ++output) {
        float* const block = blocks.data() + output / block_width * inputs * block_width;
        for (std::size_t input = 0; input < inputs; ++input) {
            block[input * block_width + output % block_width] = weight_of(output, input);
        }
    }
    return blocks;
}

Floats packed_kernel(const FoldedKernel& kernel, std::size_t outputs, std::size_t inputs, std::size_t kernel_px) {
    const std::size_t area = kernel_px * kernel_px;
    return packed(outputs, area * inputs, [&](std::size_t output, std::size_t index) {
        return kernel.values[(output * inputs + index % inputs) * area + index / inputs];
    });
}

}  // namespace

AffineLayer::AffineLayer(Points points, Weights weights, bool relu)
    : points_(std::move(points)), weights_(std::move(weights)), relu_(relu), out_(points_.out_size, 0.0F) {}

const float* AffineLayer::run(const float* in, const float* skip) {
    multiply({.in = in,
              .from = points_.from,
              .window = points_.window,
              .weights = {.first = weights_.blocks.data(), .block_step = points_.window.inputs() * block_width},
              .outputs = weights_.bias.size(),
              .bias = weights_.bias.data(),
              .skip = skip,
              .relu = relu_,
              .out = out_.data(),
              .to = points_.to});
    return out_.data();
}

MapShape shape_after(const ConvolutionRow& row, const MapShape& in) {
    return {strided(in.side, row.stride), row.channels};
}

FoldedKernel folded_kernel(NamedWeights& weights, const std::string& prefix, std::size_t outputs, std::size_t inputs,
                           std::size_t kernel_px) {
    FoldedKernel kernel{weights.take(prefix + ".conv.weight", {outputs, inputs, kernel_px, kernel_px}),
                        Floats(outputs)};
    const std::vector<float> factor = weights.take(prefix + ".norm.weight", {outputs});
    const std::vector<float> shift = weights.take(prefix + ".norm.bias", {outputs});
    const std::vector<float> mean = weights.take(prefix + ".norm.running_mean", {outputs});
    const std::vector<float> variance = weights.take(prefix + ".norm.running_var", {outputs});
    const std::size_t count = inputs * kernel_px * kernel_px;
    for (std::size_t output = 0; output < outputs; ++output) {
        const double scale = factor[output] / std::sqrt(variance[output] + batch_norm_epsilon);
        kernel.bias[output] = static_cast<float>(shift[output] - mean[output] * scale);
        for (std::size_t index = output * count; index < (output + 1) * count; ++index) {
            kernel.values[index] = static_cast<float>(kernel.values[index] * scale);
        }
    }
    return kernel;
}

AffineLayer convolution(NamedWeights& weights, const std::string& prefix, const MapShape& in,
                        const ConvolutionRow& row) {
    FoldedKernel kernel = folded_kernel(weights, prefix, row.channels, in.channels, row.kernel_px);
    const MapShape out = shape_after(row, in);
    std::vector<std::size_t> from = places(in, row.stride);
    for (std::size_t& start : from) {
        start -= row.kernel_px / 2 * (in.row_step() + in.channels);
    }
    return {{.from = std::move(from),
             .window = {.rows = row.kernel_px, .length = row.kernel_px * in.channels, .row_step = in.row_step()},
             .to = places(out),
             .out_size = out.size()},
            {packed_kernel(kernel, row.channels, in.channels, row.kernel_px), std::move(kernel.bias)},
            row.relu};
}

AffineLayer linear(NamedWeights& weights, const std::string& prefix, const LinearRow& row,
                   std::vector<std::size_t> from) {
    const std::vector<float> matrix = weights.take(prefix + ".weight", {row.outputs, row.inputs});
    const std::vector<float> bias = weights.take(prefix + ".bias", {row.outputs});
    Floats blocks = packed(row.outputs, row.inputs,
                           [&](std::size_t output, std::size_t input) { return matrix[output * row.inputs + input]; });
    std::vector<std::size_t> to = packed_tokens(from.size(), row.outputs);
    const std::size_t out_size = from.size() * row.outputs;
    return {{std::move(from), {.length = row.inputs}, std::move(to), out_size},
            {std::move(blocks), Floats(bias.begin(), bias.end())},
            row.relu};
}

std::vector<std::size_t> packed_tokens(std::size_t count, std::size_t width) {
    std::vector<std::size_t> starts(count);
    for (std::size_t token = 0; token < count; ++token) {
        starts[token] = token * width;
    }
    return starts;
}

}  // namespace ddtool::native

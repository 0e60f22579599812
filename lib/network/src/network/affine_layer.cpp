#include "network/affine_layer.hpp"

#include "network/weight_blocks.hpp"

namespace ddtool::network {
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

AffineLayer linear(NamedWeights& weights, const std::string& prefix, const LinearRow& row,
                   std::vector<std::size_t> from) {
    const std::vector<float> matrix = weights.take(prefix + ".weight", {row.outputs, row.inputs});
    const std::vector<float> bias = weights.take(prefix + ".bias", {row.outputs});
    Floats blocks = packed_weights(row.outputs, row.inputs, [&](std::size_t output, std::size_t input) {
        return matrix[output * row.inputs + input];
    });
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

}  // namespace ddtool::network

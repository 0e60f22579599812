#include "network/layer_norm.hpp"

#include <cmath>

#include "base/lanes.hpp"

namespace ddtool::network {
namespace {

constexpr double epsilon = 1e-5;

Floats taken(NamedWeights& weights, const std::string& name, std::size_t width) {
    const std::vector<float> values = weights.take(name, {width});
    return {values.begin(), values.end()};
}

DDTOOL_VECTORISED void normalise(const float* in, const Floats& weight, const Floats& bias, float* out) {
    const std::size_t width = weight.size();
    Lanes value;
    Lanes sum{};
    for (std::size_t i = 0; i < width; i += lane_count) {
        load(value, in + i);
        sum += value;
    }
    const auto mean = static_cast<float>(sum_of(sum) / static_cast<double>(width));
    Lanes squares{};
    for (std::size_t i = 0; i < width; i += lane_count) {
        load(value, in + i);
        squares += (value - mean) * (value - mean);
    }
    const double variance = sum_of(squares) / static_cast<double>(width);
    const auto scale = static_cast<float>(1.0 / std::sqrt(variance + epsilon));
    for (std::size_t i = 0; i < width; i += lane_count) {
        Lanes factor;
        Lanes shift;
        load(value, in + i);
        load(factor, weight.data() + i);
        load(shift, bias.data() + i);
        store(out + i, (value - mean) * scale * factor + shift);
    }
}

}  // namespace

LayerNorm::LayerNorm(NamedWeights& weights, const std::string& prefix, std::size_t tokens, std::size_t width)
    : tokens_(tokens),
      weight_(taken(weights, prefix + ".weight", width)),
      bias_(taken(weights, prefix + ".bias", width)),
      out_(tokens * width) {}

const float* LayerNorm::run(const float* in) {
    for (std::size_t token = 0; token < tokens_; ++token) {
        normalise(in + token * weight_.size(), weight_, bias_, out_.data() + token * weight_.size());
    }
    return out_.data();
}

}  // namespace ddtool::network

#include "train/torch/inverted_residual.hpp"

#include <algorithm>

namespace ddtool::models {
namespace {

/// The multiple of 8 nearest to `channels`, no more than 10 % below it (Sandler et al.'s rule for layer widths).
std::int64_t rounded_to_8(std::int64_t channels) {
    const std::int64_t rounded = std::max<std::int64_t>(8, (channels + 4) / 8 * 8);
    return 10 * rounded < 9 * channels ? rounded + 8 : rounded;
}

torch::nn::Conv2d pointwise(std::int64_t in_channels, std::int64_t out_channels) {
    return torch::nn::Conv2d(torch::nn::Conv2dOptions(in_channels, out_channels, 1));
}

}  // namespace

SqueezeExcite::SqueezeExcite(std::int64_t channels)
    : squeeze_(register_module("squeeze", pointwise(channels, rounded_to_8(channels / 4)))),
      excite_(register_module("excite", pointwise(rounded_to_8(channels / 4), channels))) {}

torch::Tensor SqueezeExcite::forward(const torch::Tensor& x) {
    const torch::Tensor mean = x.mean({2, 3}, /*keepdim=*/true);
    return x * torch::hardsigmoid(excite_(torch::relu(squeeze_(mean))));
}

InvertedResidual::InvertedResidual(std::int64_t in_channels, const BottleneckRow& row, const BatchNormOptions& norm)
    : layers_(register_module("layers", torch::nn::Sequential())),
      has_skip_(row.stride == 1 && in_channels == row.out_channels) {
    if (row.expanded != in_channels) {
        layers_->push_back(std::make_shared<ConvNorm>(ConvNormOptions{.in_channels = in_channels,
                                                                      .out_channels = row.expanded,
                                                                      .kernel_px = 1,
                                                                      .activation = row.activation,
                                                                      .norm = norm}));
    }
    layers_->push_back(std::make_shared<ConvNorm>(ConvNormOptions{.in_channels = row.expanded,
                                                                  .out_channels = row.expanded,
                                                                  .kernel_px = row.kernel_px,
                                                                  .stride = row.stride,
                                                                  .groups = row.expanded,
                                                                  .activation = row.activation,
                                                                  .norm = norm}));
    if (row.squeeze_excite) {
        layers_->push_back(std::make_shared<SqueezeExcite>(row.expanded));
    }
    layers_->push_back(std::make_shared<ConvNorm>(ConvNormOptions{.in_channels = row.expanded,
                                                                  .out_channels = row.out_channels,
                                                                  .kernel_px = 1,
                                                                  .activation = Activation::none,
                                                                  .norm = norm}));
}

torch::Tensor InvertedResidual::forward(const torch::Tensor& x) {
    const torch::Tensor out = layers_->forward(x);
    return has_skip_ ? out + x : out;
}

}  // namespace ddtool::models

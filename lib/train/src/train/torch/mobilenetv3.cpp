#include "train/torch/mobilenetv3.hpp"

#include <algorithm>
#include <array>

namespace ddtool::train_torch {
namespace {

/// The multiple of 8 nearest to `channels`, but at most 10 % below it (the rule of Sandler et al. for the widths of
/// layers).
std::int64_t rounded_to_8(std::int64_t channels) {
    const std::int64_t rounded = std::max<std::int64_t>(8, (channels + 4) / 8 * 8);
    return 10 * rounded < 9 * channels ? rounded + 8 : rounded;
}

torch::nn::Conv2d pointwise(std::int64_t in_channels, std::int64_t out_channels) {
    return torch::nn::Conv2d(torch::nn::Conv2dOptions(in_channels, out_channels, 1));
}

using enum Activation;

// The rows "bneck" of table 1 in Howard et al. 2019.
constexpr std::array<BottleneckRow, 15> bottlenecks{{
    // kernel, exp size, #out, SE, NL, s
    {3, 16, 16, false, relu, 1},
    {3, 64, 24, false, relu, 2},
    {3, 72, 24, false, relu, 1},
    {5, 72, 40, true, relu, 2},
    {5, 120, 40, true, relu, 1},
    {5, 120, 40, true, relu, 1},
    {3, 240, 80, false, hard_swish, 2},
    {3, 200, 80, false, hard_swish, 1},
    {3, 184, 80, false, hard_swish, 1},
    {3, 184, 80, false, hard_swish, 1},
    {3, 480, 112, true, hard_swish, 1},
    {3, 672, 112, true, hard_swish, 1},
    {5, 672, 160, true, hard_swish, 2},
    {5, 960, 160, true, hard_swish, 1},
    {5, 960, 160, true, hard_swish, 1},
}};
constexpr std::int64_t stem_channels = 16;
constexpr std::int64_t last_channels = 960;
constexpr std::int64_t hidden_width = 1280;
constexpr double dropout = 0.2;  // this and the following value are those of torchvision
constexpr BatchNormOptions norm{.epsilon = 0.001, .momentum = 0.01};

torch::nn::Sequential maps_of(std::int64_t in_channels) {
    torch::nn::Sequential maps(std::make_shared<ConvNorm>(ConvNormOptions{.in_channels = in_channels,
                                                                          .out_channels = stem_channels,
                                                                          .stride = 2,
                                                                          .activation = hard_swish,
                                                                          .norm = norm}));
    std::int64_t channels = stem_channels;
    for (const BottleneckRow& row : bottlenecks) {
        maps->push_back(std::make_shared<InvertedResidual>(channels, row, norm));
        channels = row.out_channels;
    }
    maps->push_back(std::make_shared<ConvNorm>(ConvNormOptions{.in_channels = channels,
                                                               .out_channels = last_channels,
                                                               .kernel_px = 1,
                                                               .activation = hard_swish,
                                                               .norm = norm}));
    return maps;
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

MobileNetV3::MobileNetV3(const MobileNetV3Options& options)
    : maps_(register_module("maps", maps_of(options.in_channels))),
      hidden_(register_module("hidden", torch::nn::Linear(last_channels, hidden_width))),
      dropout_(register_module("dropout", torch::nn::Dropout(dropout))),
      head_(register_module("head", torch::nn::Linear(hidden_width, options.classes))) {
    draw_weights(*this);
}

torch::Tensor MobileNetV3::forward(const torch::Tensor& images) {
    const torch::Tensor mean = feature_map(images).mean({2, 3});
    return logits_of(head_, dropout_(torch::hardswish(hidden_(mean))));
}

torch::Tensor MobileNetV3::feature_map(const torch::Tensor& images) { return maps_->forward(images); }

}  // namespace ddtool::train_torch

#include "train/torch/mobilenetv3.hpp"

#include <array>

#include "train/torch/inverted_residual.hpp"

namespace ddtool::models {
namespace {

using enum Activation;

// Howard et al. 2019, table 1, the rows "bneck".
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
constexpr double dropout = 0.2;  // of torchvision, as the next
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

}  // namespace ddtool::models

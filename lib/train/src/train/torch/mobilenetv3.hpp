#pragma once

#include <torch/torch.h>

#include <cstdint>
#include <memory>

#include "train/torch/layers.hpp"
#include "train/torch/network.hpp"

namespace ddtool::train_torch {

/// A "bneck" row of Howard et al. 2019, table 1.
struct BottleneckRow {
    std::int64_t kernel_px = 0;
    std::int64_t expanded = 0;                 ///< "exp size": channels of the depthwise convolution
    std::int64_t out_channels = 0;             ///< "#out"
    bool squeeze_excite = false;               ///< "SE"
    Activation activation = Activation::none;  ///< "NL"
    std::int64_t stride = 0;                   ///< "s"
};

/// Multiplies each channel by a factor that depends on all pixels (Hu et al. 2018, with the hard sigmoid of
/// MobileNetV3).
class SqueezeExcite : public torch::nn::Module {
public:
    explicit SqueezeExcite(std::int64_t channels);
    torch::Tensor forward(const torch::Tensor& x);

private:
    torch::nn::Conv2d squeeze_;
    torch::nn::Conv2d excite_;
};

/// Expansion, depthwise convolution, squeeze-and-excite, linear projection (Sandler et al. 2018; Howard et al. 2019,
/// figure 4).
class InvertedResidual : public torch::nn::Module {
public:
    InvertedResidual(std::int64_t in_channels, const BottleneckRow& row, const BatchNormOptions& norm);
    torch::Tensor forward(const torch::Tensor& x);

private:
    torch::nn::Sequential layers_;
    bool has_skip_;
};

struct MobileNetV3Options {
    std::int64_t in_channels = 1;
    std::int64_t classes = 2;
};

/// MobileNetV3-Large (Howard et al. 2019, table 1), with which the paper compares. Everything that the table leaves
/// open is as in torchvision. Takes images of any size.
class MobileNetV3 : public Network {
public:
    explicit MobileNetV3(const MobileNetV3Options& options = {});
    torch::Tensor forward(const torch::Tensor& images) override;

    /// images: [n, in_channels, height, width]. Returns the last map, [n, 960, height / 32, width / 32].
    torch::Tensor feature_map(const torch::Tensor& images);

private:
    torch::nn::Sequential maps_;
    torch::nn::Linear hidden_;
    torch::nn::Dropout dropout_;
    torch::nn::Linear head_;
};

}  // namespace ddtool::train_torch

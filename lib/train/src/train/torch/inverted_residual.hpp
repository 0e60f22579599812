#pragma once

#include <torch/torch.h>

#include <cstdint>
#include <memory>

#include "train/torch/layers.hpp"

namespace ddtool::models {

/// A "bneck" row of Howard et al. 2019, table 1.
struct BottleneckRow {
    std::int64_t kernel_px = 0;
    std::int64_t expanded = 0;                 ///< "exp size": channels of the depthwise convolution
    std::int64_t out_channels = 0;             ///< "#out"
    bool squeeze_excite = false;               ///< "SE"
    Activation activation = Activation::none;  ///< "NL"
    std::int64_t stride = 0;                   ///< "s"
};

/// Weighs each channel by what all pixels say together (Hu et al. 2018, with the hard sigmoid of MobileNetV3).
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

}  // namespace ddtool::models

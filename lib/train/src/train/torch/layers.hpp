#pragma once

#include <torch/torch.h>

#include <cstdint>
#include <memory>

#include "train/torch/batch_norm.hpp"

namespace ddtool::train_torch {

enum class Activation : std::uint8_t { none, relu, hard_swish };

torch::Tensor activated(const torch::Tensor& x, Activation activation);

struct ConvNormOptions {
    std::int64_t in_channels = 0;
    std::int64_t out_channels = 0;
    std::int64_t kernel_px = 3;  ///< odd; padded so that stride 1 keeps the size
    std::int64_t stride = 1;
    std::int64_t groups = 1;
    Activation activation = Activation::relu;
    BatchNormOptions norm = {};
};

/// Convolution without bias, batch normalisation, activation.
class ConvNorm : public torch::nn::Module {
public:
    explicit ConvNorm(const ConvNormOptions& options);
    torch::Tensor forward(const torch::Tensor& x);

private:
    torch::nn::Conv2d conv_;
    std::shared_ptr<BatchNorm> norm_;
    Activation activation_;
};

/// The head. It computes in float32 even under autocast, because a logit in bf16 has only three digits.
torch::Tensor logits_of(torch::nn::Linear& head, const torch::Tensor& features);

/// Draws the weights of every convolution as He et al. 2015 (normal, by fan-out) and of every linear layer as Glorot
/// and Bengio 2010 (uniform); their biases are 0.
void draw_weights(torch::nn::Module& network);

/// Changes the layout of the weights of every convolution to channels-last, and so the layout of every map that the
/// network makes. LibTorch's convolutions, and above all its max pooling, are several times faster with it.
void lay_out_channels_last(torch::nn::Module& network);

}  // namespace ddtool::train_torch

#pragma once

#include <torch/torch.h>

#include <cstdint>
#include <memory>

#include "train/torch/layers.hpp"

namespace ddtool::models {

/// Residual block of two 3x3 convolutions (He et al. 2016, figure 5 left). Where the shape changes, the skip is a 1x1
/// projection (their option B).
class BasicBlock : public torch::nn::Module {
public:
    BasicBlock(std::int64_t in_channels, std::int64_t out_channels, std::int64_t stride);
    torch::Tensor forward(const torch::Tensor& x);

private:
    std::shared_ptr<ConvNorm> first_;
    std::shared_ptr<ConvNorm> second_;
    std::shared_ptr<ConvNorm> projection_;  // null: the skip is the input itself
};

}  // namespace ddtool::models

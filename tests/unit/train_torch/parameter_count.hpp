#pragma once

#include <torch/torch.h>

#include <cstdint>

namespace ddtool::train_torch {

inline std::int64_t parameter_count(const torch::nn::Module& network) {
    std::int64_t count = 0;
    for (const torch::Tensor& parameter : network.parameters()) {
        count += parameter.numel();
    }
    return count;
}

}  // namespace ddtool::train_torch

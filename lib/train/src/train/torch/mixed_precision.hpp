#pragma once

#include <torch/torch.h>

#include <string>

namespace ddtool::train_torch {

/// While an object of this class exists, operations that gain from it run in bfloat16 on that device (LibTorch's
/// autocast). Weights, and operations that need the larger precision, stay in float32. For "fp32" it has no effect.
class MixedPrecision {
public:
    MixedPrecision(const std::string& precision, torch::DeviceType device);
    ~MixedPrecision();
    MixedPrecision(const MixedPrecision&) = delete;
    MixedPrecision& operator=(const MixedPrecision&) = delete;

private:
    bool on_;
    torch::DeviceType device_;
};

}  // namespace ddtool::train_torch

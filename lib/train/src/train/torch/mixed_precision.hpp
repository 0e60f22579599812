#pragma once

#include <torch/torch.h>

#include <string>

namespace ddtool::train_torch {

/// While one lives, operations that gain from it run in bfloat16 on that device (LibTorch's autocast); weights and
/// what needs the range stay float32. Nothing happens for "fp32".
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

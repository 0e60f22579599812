#pragma once

#include <torch/torch.h>

#include <cmath>
#include <cstdint>

namespace ddtool::train_torch {

/// A tensor of that shape filled by a formula that gives the same on every machine and in every version of LibTorch:
/// sin(phase + (index^2 mod 65537)), index in row-major order. scripts/make-mobilenet-reference has it too.
inline torch::Tensor formula_tensor(torch::IntArrayRef shape, double phase) {
    torch::Tensor values = torch::empty(shape, torch::kDouble);
    auto* value = values.data_ptr<double>();
    for (std::int64_t index = 0; index < values.numel(); ++index) {
        value[index] = std::sin(phase + static_cast<double>(index * index % 65537));
    }
    return values;
}

/// Weights of two and more axes become 2 / sqrt(fan-in) times the formula; what has one axis is shifted a little from
/// where it starts, 0 or 1. The phase is the parameter's number.
inline void fill_by_formula(torch::nn::Module& network) {
    const torch::NoGradGuard no_grad;
    double phase = 0.0;
    for (torch::Tensor& parameter : network.parameters()) {
        const torch::Tensor values = formula_tensor(parameter.sizes(), phase);
        if (parameter.dim() > 1) {
            const auto fan_in = static_cast<double>(parameter.numel() / parameter.size(0));
            parameter.copy_(values * (2.0 / std::sqrt(fan_in)));
        } else {
            parameter.add_(0.1 * values);
        }
        phase += 1.0;
    }
}

/// n different images of dots, [n, 1, size_px, size_px], 0 or 1.
inline torch::Tensor formula_images(std::int64_t n, std::int64_t size_px) {
    return formula_tensor({n, 1, size_px, size_px}, 0.5).gt(0.9).to(torch::kFloat);
}

}  // namespace ddtool::train_torch

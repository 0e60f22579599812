#pragma once

#include <torch/torch.h>

#include <cmath>
#include <cstdint>

namespace ddtool::train_torch {

/// A tensor that is filled by a formula, which gives the same values on every machine and in every version of LibTorch:
/// sin(phase + (index^2 mod 65537)), with the index in row-major order. scripts/make-mobilenet-reference uses the same
/// formula.
inline torch::Tensor formula_tensor(torch::IntArrayRef shape, double phase) {
    torch::Tensor values = torch::empty(shape, torch::kDouble);
    auto* value = values.data_ptr<double>();
    for (std::int64_t index = 0; index < values.numel(); ++index) {
        value[index] = std::sin(phase + static_cast<double>(index * index % 65537));
    }
    return values;
}

/// Fills all parameters of a network. Those with two or more axes become 2 / sqrt(fan-in) times the formula; those with
/// one axis are shifted a little from their initial value of 0 or 1. The phase is the number of the parameter.
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

/// n different images of dots, as a tensor [n, 1, size_px, size_px] of zeros and ones.
inline torch::Tensor formula_images(std::int64_t n, std::int64_t size_px) {
    return formula_tensor({n, 1, size_px, size_px}, 0.5).gt(0.9).to(torch::kFloat);
}

}  // namespace ddtool::train_torch

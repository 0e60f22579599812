#pragma once

#include <torch/torch.h>

#include <cmath>
#include <cstdint>

namespace ddtool::models {

/// A tensor of that shape filled by a formula, the same on every machine and in every version of LibTorch:
/// sin(phase + index) in row-major order.
inline torch::Tensor formula_tensor(torch::IntArrayRef shape, double phase) {
    torch::Tensor values = torch::empty(shape, torch::kDouble);
    auto* value = values.data_ptr<double>();
    for (std::int64_t index = 0; index < values.numel(); ++index) {
        value[index] = std::sin(phase + static_cast<double>(index));
    }
    return values;
}

/// Fills parameters and running statistics by formula: weights of two and more axes scaled by sqrt(2 / fan-in), scales
/// around 1, everything else small. scripts/make-mobilenet-reference does the same.
inline void fill_by_formula(torch::nn::Module& network) {
    const torch::NoGradGuard no_grad;
    double phase = 0.0;
    for (torch::Tensor& parameter : network.parameters()) {
        const torch::Tensor values = formula_tensor(parameter.sizes(), phase);
        if (parameter.dim() > 1) {
            parameter.copy_(values * std::sqrt(2.0 * static_cast<double>(parameter.size(0)) /
                                               static_cast<double>(parameter.numel())));
        } else {
            parameter.add_(0.1 * values);
        }
        phase += 1.0;
    }
}

/// n different images of dots, [n, 1, size_px, size_px], 0 or 1.
inline torch::Tensor formula_images(std::int64_t n, std::int64_t size_px) {
    return formula_tensor({n, 1, size_px, size_px}, 0.5).mul(1000.0).sin().gt(0.8).to(torch::kFloat);
}

}  // namespace ddtool::models

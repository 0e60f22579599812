#pragma once

#include <torch/torch.h>

#include <string>

namespace ddtool::inference {

/// The two values in 0..1 that a network's logits [n, 2] stand for: softmax where it was trained by cross-entropy,
/// where they sum to one; a sigmoid each where it was trained by bce.
torch::Tensor output_values(const std::string& loss, const torch::Tensor& logits);

}  // namespace ddtool::inference

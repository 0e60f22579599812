#pragma once

#include <torch/torch.h>

#include <string>

namespace ddtool::training {

/// The loss of each sample, [n]. logits: [n, 2]; classes: [n], 0 or 1. cross-entropy takes the softmax of the two
/// logits; bce takes each logit for a class of its own, against 0 and 1, and averages both. Throws UsageError for
/// another name.
torch::Tensor sample_losses(const std::string& loss, const torch::Tensor& logits, const torch::Tensor& classes);

}  // namespace ddtool::training

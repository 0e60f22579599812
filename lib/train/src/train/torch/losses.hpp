#pragma once

#include <torch/torch.h>

#include <array>
#include <string>
#include <vector>

#include "dataset/dataset.hpp"
#include "train/train_settings.hpp"

namespace ddtool::train_torch {

/// The loss of each sample, [n]. logits: [n, 2]; classes: [n], 0 or 1. cross-entropy uses the softmax of the two
/// logits; bce compares the sigmoid of each logit with 0 or 1 and averages both. Throws UsageError for another name.
torch::Tensor sample_losses(const std::string& loss, const torch::Tensor& logits, const torch::Tensor& classes);

/// The two values in 0..1 that correspond to a network's logits [n, 2]: for a network trained with cross-entropy their
/// softmax, which sums to one; for bce the sigmoid of each.
torch::Tensor output_values(const std::string& loss, const torch::Tensor& logits);

/// The weight of a sample of each class; the mean weight over the training part is one.
struct ClassWeights {
    std::array<double, 2> of{1.0, 1.0};

    /// Returns one weight for each sample, [n], for classes [n].
    [[nodiscard]] torch::Tensor at(const torch::Tensor& classes) const;
};

/// Weights that give both classes the same total weight if settings.class_weights is true, and otherwise 1 for both.
/// `samples` must hold samples of both classes.
ClassWeights class_weights(const dataset::Dataset& data, const std::vector<std::size_t>& samples,
                           const train::TrainSettings& settings);

}  // namespace ddtool::train_torch

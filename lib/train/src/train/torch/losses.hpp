#pragma once

#include <torch/torch.h>

#include <array>
#include <string>
#include <vector>

#include "dataset/dataset.hpp"
#include "train/train_settings.hpp"

namespace ddtool::train_torch {

/// The loss of each sample, [n]. logits: [n, 2]; classes: [n], 0 or 1. cross-entropy takes the softmax of the two
/// logits; bce takes each logit for a class of its own, against 0 and 1, and averages both. Throws UsageError for
/// another name.
torch::Tensor sample_losses(const std::string& loss, const torch::Tensor& logits, const torch::Tensor& classes);

/// The two values in 0..1 that a network's logits [n, 2] stand for: softmax where it was trained by cross-entropy,
/// where they sum to one; a sigmoid each where it was trained by bce.
torch::Tensor output_values(const std::string& loss, const torch::Tensor& logits);

/// What a sample of each class counts; over the training part the mean is one.
struct ClassWeights {
    std::array<double, 2> of{1.0, 1.0};

    /// One weight a sample, [n], for classes [n].
    [[nodiscard]] torch::Tensor at(const torch::Tensor& classes) const;
};

/// Each class the same in all where the settings ask for it. There are samples of both.
ClassWeights class_weights(const dataset::Dataset& data, const std::vector<std::size_t>& samples,
                           const train::TrainSettings& settings);

}  // namespace ddtool::train_torch

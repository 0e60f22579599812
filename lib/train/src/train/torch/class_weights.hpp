#pragma once

#include <torch/torch.h>

#include <array>
#include <vector>

#include "dataset/dataset.hpp"
#include "train/train_settings.hpp"

namespace ddtool::training {

/// What a sample of each class counts; over the training part the mean is one.
struct ClassWeights {
    std::array<double, 2> of{1.0, 1.0};

    /// One weight a sample, [n], for classes [n].
    [[nodiscard]] torch::Tensor at(const torch::Tensor& classes) const;
};

/// Each class the same in all where the settings ask for it. There are samples of both.
ClassWeights class_weights(const dataset::Dataset& data, const std::vector<std::size_t>& samples,
                           const learning::TrainSettings& settings);

}  // namespace ddtool::training

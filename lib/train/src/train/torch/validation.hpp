#pragma once

#include <vector>

#include "dataset/dataset.hpp"
#include "train/torch/losses.hpp"
#include "train/torch/network.hpp"
#include "train/train_settings.hpp"

namespace ddtool::train_torch {

struct ValidationResult {
    double loss = 0.0;  ///< mean, weighted by class as in training
    double accuracy = 0.0;
    double f1 = 0.0;  ///< degenerate is the positive class
    double auc = 0.0;
};

/// Runs the network in evaluation mode over samples of a data set, without augmentation.
ValidationResult validate(Network& network, const dataset::Dataset& data, const std::vector<std::size_t>& samples,
                          const train::TrainSettings& settings, const ClassWeights& weights, torch::Device device);

}  // namespace ddtool::train_torch

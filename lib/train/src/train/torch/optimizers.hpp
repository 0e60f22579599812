#pragma once

#include <torch/torch.h>

#include <memory>
#include <vector>

#include "train/train_settings.hpp"

namespace ddtool::train_torch {

/// adam (Kingma and Ba 2015), rmsprop (Hinton 2012) or adamw (Loshchilov and Hutter 2019). Throws UsageError for
/// another name.
std::unique_ptr<torch::optim::Optimizer> make_optimizer(const train::OptimizerSettings& settings,
                                                        const std::vector<torch::Tensor>& parameters);

/// The learning rate of a step in 0..steps-1. It rises linearly during the warm-up and then falls as half a cosine to
/// final_rate_share of its maximum (Loshchilov and Hutter 2017, without restarts).
double learning_rate(const train::OptimizerSettings& settings, std::size_t step, std::size_t steps);

void set_learning_rate(torch::optim::Optimizer& optimizer, double rate);

}  // namespace ddtool::train_torch

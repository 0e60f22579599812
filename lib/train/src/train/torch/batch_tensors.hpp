#pragma once

#include <torch/torch.h>

#include "train/batch_loader.hpp"

namespace ddtool::training {

struct BatchTensors {
    torch::Tensor images;   ///< [n, 1, size_px, size_px], channels last
    torch::Tensor classes;  ///< [n]
};

/// The batch on the device. On the CPU the tensors are views: the batch must live as long.
BatchTensors tensors_of(learning::Batch& batch, torch::Device device);

}  // namespace ddtool::training

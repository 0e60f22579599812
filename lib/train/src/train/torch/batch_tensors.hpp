#pragma once

#include <torch/torch.h>

#include "train/batch_loader.hpp"

namespace ddtool::train_torch {

struct BatchTensors {
    torch::Tensor images;   ///< [n, 1, size_px, size_px], channels last
    torch::Tensor classes;  ///< [n]
};

/// The batch on the device. On the CPU the tensors are views of the batch, which must live as long as they do.
inline BatchTensors tensors_of(train::Batch& batch, torch::Device device) {
    const auto count = static_cast<std::int64_t>(batch.classes.size());
    const auto size = static_cast<std::int64_t>(batch.size_px);
    const torch::Tensor images = torch::from_blob(batch.images.data(), {count, 1, size, size});
    const torch::Tensor classes = torch::from_blob(batch.classes.data(), {count}, torch::kInt64);
    return {images.to(device).contiguous(torch::MemoryFormat::ChannelsLast), classes.to(device)};
}

}  // namespace ddtool::train_torch

#include "train/torch/batch_tensors.hpp"

namespace ddtool::training {

BatchTensors tensors_of(learning::Batch& batch, torch::Device device) {
    const auto count = static_cast<std::int64_t>(batch.classes.size());
    const auto size = static_cast<std::int64_t>(batch.size_px);
    const torch::Tensor images = torch::from_blob(batch.images.data(), {count, 1, size, size});
    const torch::Tensor classes = torch::from_blob(batch.classes.data(), {count}, torch::kInt64);
    return {images.to(device).contiguous(torch::MemoryFormat::ChannelsLast), classes.to(device)};
}

}  // namespace ddtool::training

#include "train/torch/torch_model.hpp"

#include "ddtool/base/error.hpp"
#include "train/torch/mixed_precision.hpp"

namespace ddtool::train_torch {

TorchModel::TorchModel(ModelDescription description, Forward forward, const train::RunOptions& options)
    : description_(std::move(description)),
      forward_(std::move(forward)),
      device_(options.device),
      precision_(options.precision),
      threads_(static_cast<int>(options.threads)) {}

void TorchModel::run(std::span<const float> images, std::span<double> degrees) {
    const auto size = static_cast<std::int64_t>(description_.image.size_px);
    const auto count = static_cast<std::int64_t>(degrees.size());
    if (images.size() != degrees.size() * description_.image.size_px * description_.image.size_px) {
        throw Error("a model for images of " + std::to_string(size) + " x " + std::to_string(size) +
                    " pixels was given others");
    }
    if (threads_ > 0 && at::get_num_threads() != threads_) {
        at::set_num_threads(threads_);
    }
    const c10::InferenceMode inference;
    const MixedPrecision precision(precision_, device_.type());
    // from_blob() takes no pointer to const, but nothing writes through this one.
    const torch::Tensor input = torch::from_blob(const_cast<float*>(images.data()), {count, 1, size, size}).to(device_);
    const torch::Tensor values = forward_(input).select(1, degenerate_output).to(torch::kCPU, torch::kFloat64);
    std::copy_n(values.contiguous().data_ptr<double>(), degrees.size(), degrees.begin());
}

}  // namespace ddtool::train_torch

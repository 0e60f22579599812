#pragma once

#include <torch/torch.h>

#include <functional>
#include <string>

#include "train/engine.hpp"

namespace ddtool::train_torch {

/// Runs a function of LibTorch on images in plain memory.
class TorchModel : public DegreeModel {
public:
    /// Maps images [n, 1, size_px, size_px] to the two values [n, 2].
    using Forward = std::function<torch::Tensor(const torch::Tensor& images)>;

    TorchModel(ModelDescription description, Forward forward, const train::RunOptions& options);

    [[nodiscard]] const ModelDescription& description() const override { return description_; }
    void run(std::span<const float> images, std::span<double> degrees) override;

private:
    ModelDescription description_;
    Forward forward_;
    torch::Device device_;
    std::string precision_;
    int threads_;
};

}  // namespace ddtool::train_torch

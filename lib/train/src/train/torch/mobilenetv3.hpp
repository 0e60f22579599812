#pragma once

#include <torch/torch.h>

#include <cstdint>
#include <memory>

#include "train/torch/layers.hpp"
#include "train/torch/network.hpp"

namespace ddtool::models {

struct MobileNetV3Options {
    std::int64_t in_channels = 1;
    std::int64_t classes = 2;
};

/// MobileNetV3-Large (Howard et al. 2019, table 1), the paper's comparison. Everything the table leaves open is as in
/// torchvision. Takes images of any size.
class MobileNetV3 : public Network {
public:
    explicit MobileNetV3(const MobileNetV3Options& options = {});
    torch::Tensor forward(const torch::Tensor& images) override;

    /// images: [n, in_channels, height, width]. Returns the last map, [n, 960, height / 32, width / 32].
    torch::Tensor feature_map(const torch::Tensor& images);

private:
    torch::nn::Sequential maps_;
    torch::nn::Linear hidden_;
    torch::nn::Dropout dropout_;
    torch::nn::Linear head_;
};

}  // namespace ddtool::models

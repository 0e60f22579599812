#pragma once

#include <torch/torch.h>

#include <cstdint>
#include <memory>

#include "network/dd_tables.hpp"
#include "train/torch/encoder_layer.hpp"
#include "train/torch/layers.hpp"
#include "train/torch/network.hpp"

namespace ddtool::models {

/// The networks of learning/dd_tables.hpp.
class DDModel : public Network {
public:
    DDModel(const native::DDModelTable& table, std::int64_t size_px);
    torch::Tensor forward(const torch::Tensor& images) override;

    /// The backbone: images to maps [n, channels, side, side].
    torch::Tensor feature_map(const torch::Tensor& images);
    /// The neck: maps to one vector for each image, [n, encoder width], float32.
    torch::Tensor features(const torch::Tensor& map);

private:
    std::shared_ptr<ConvNorm> stem_;
    torch::nn::Sequential groups_;
    torch::nn::Linear embedding_;
    torch::Tensor position_;  // [tokens, encoder width]
    std::shared_ptr<EncoderLayer> encoder_;
    torch::nn::LayerNorm norm_;
    torch::nn::Linear head_;
};

}  // namespace ddtool::models

#pragma once

#include <torch/torch.h>

#include <cstdint>
#include <memory>
#include <vector>

#include "models/encoder_layer.hpp"
#include "models/layers.hpp"
#include "models/network.hpp"

namespace ddtool::models {

/// First convolution of the backbone. A 3x3 max pooling of stride 2 follows.
struct StemRow {
    std::int64_t kernel_px = 0;
    std::int64_t stride = 0;
    std::int64_t channels = 0;
};

/// One of the backbone's "composite layers": BasicBlocks, the first of which may change the shape.
struct GroupRow {
    std::int64_t blocks = 0;
    std::int64_t channels = 0;
    std::int64_t stride = 0;  ///< of the first block
};

/// A network of the DD-Model's kind (paper, section "Degeneracy Detection Model" and its figure; docs/models.md tells
/// what the paper leaves open): residual backbone, transformer neck, two-way head.
struct DDModelTable {
    StemRow stem;
    std::vector<GroupRow> groups;
    EncoderOptions encoder;
};

/// The paper's: the map that goes to the neck is 256 x 28 x 28 for images of 224 x 224.
const DDModelTable& ddmodel_table();
/// The same made small, for a robot's processor.
const DDModelTable& ddmodel_lite_table();

class DDModel : public Network {
public:
    DDModel(const DDModelTable& table, std::int64_t size_px);
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

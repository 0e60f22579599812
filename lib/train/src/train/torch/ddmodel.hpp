#pragma once

#include <torch/torch.h>

#include <cstdint>
#include <memory>

#include "network/dd_tables.hpp"
#include "train/torch/layers.hpp"
#include "train/torch/network.hpp"

namespace ddtool::train_torch {

/// Residual block of two 3x3 convolutions (He et al. 2016, figure 5 left). Where the shape changes, the skip is a 1x1
/// projection (their option B).
class BasicBlock : public torch::nn::Module {
public:
    BasicBlock(std::int64_t in_channels, std::int64_t out_channels, std::int64_t stride);
    torch::Tensor forward(const torch::Tensor& x);

private:
    std::shared_ptr<ConvNorm> first_;
    std::shared_ptr<ConvNorm> second_;
    std::shared_ptr<ConvNorm> projection_;  // null: the skip is the input itself
};

/// One layer of a transformer encoder (Vaswani et al. 2017) with the normalisation first (Xiong et al. 2020) and
/// without dropout. It is made of plain operations whose views do not depend on the size of the batch. The views in
/// torch::nn::TransformerEncoder would fix the exported model to the size of the traced batch.
class EncoderLayer : public torch::nn::Module {
public:
    explicit EncoderLayer(const network::EncoderRow& row);
    /// x: [n, tokens, width] in float32. So is the result; under autocast only the matrix products are computed in
    /// bf16.
    torch::Tensor forward(const torch::Tensor& x);

private:
    torch::Tensor self_attention(const torch::Tensor& x);

    std::int64_t heads_;
    torch::nn::LayerNorm attention_norm_;
    torch::nn::Linear query_key_value_;
    torch::nn::Linear attention_out_;
    torch::nn::LayerNorm feed_forward_norm_;
    torch::nn::Linear feed_forward_in_;
    torch::nn::Linear feed_forward_out_;
};

/// The networks of network/dd_tables.hpp.
class DDModel : public Network {
public:
    DDModel(const network::DDModelTable& table, std::int64_t size_px);
    torch::Tensor forward(const torch::Tensor& images) override;

    /// The backbone: from images to maps [n, channels, side, side].
    torch::Tensor feature_map(const torch::Tensor& images);
    /// The neck: from maps to one vector per image, [n, encoder width], in float32.
    torch::Tensor features(const torch::Tensor& map);

private:
    std::shared_ptr<ConvNorm> stem_;
    torch::nn::Sequential groups_;
    torch::nn::Linear embedding_;
    torch::Tensor position_;                 // [tokens, encoder width]
    std::shared_ptr<EncoderLayer> encoder_;  // null: a network without the transformer
    torch::nn::LayerNorm norm_;
    torch::nn::Linear head_;
};

}  // namespace ddtool::train_torch

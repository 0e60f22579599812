#pragma once

#include <torch/torch.h>

#include <cstdint>

#include "network/dd_tables.hpp"

namespace ddtool::models {

/// One layer of a transformer encoder (Vaswani et al. 2017) with normalisation first (Xiong et al. 2020), without
/// dropout. On plain operations whose views leave the batch open: torch::nn::TransformerEncoder's views would carry
/// the batch of the trace into the exported model.
class EncoderLayer : public torch::nn::Module {
public:
    explicit EncoderLayer(const native::EncoderRow& row);
    /// x: [n, tokens, width], float32, which it also returns; under autocast only the products are rounded.
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

}  // namespace ddtool::models

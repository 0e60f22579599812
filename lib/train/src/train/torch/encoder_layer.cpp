#include "train/torch/encoder_layer.hpp"

#include <cmath>
#include <vector>

namespace ddtool::models {
namespace {

torch::nn::LayerNorm layer_norm(std::int64_t width) {
    return torch::nn::LayerNorm(torch::nn::LayerNormOptions({width}));
}

}  // namespace

EncoderLayer::EncoderLayer(const native::EncoderRow& row)
    : heads_(row.heads),
      attention_norm_(register_module("attention_norm", layer_norm(row.width))),
      query_key_value_(register_module("query_key_value", torch::nn::Linear(row.width, 3 * row.width))),
      attention_out_(register_module("attention_out", torch::nn::Linear(row.width, row.width))),
      feed_forward_norm_(register_module("feed_forward_norm", layer_norm(row.width))),
      feed_forward_in_(register_module("feed_forward_in", torch::nn::Linear(row.width, row.feed_forward))),
      feed_forward_out_(register_module("feed_forward_out", torch::nn::Linear(row.feed_forward, row.width))) {}

torch::Tensor EncoderLayer::forward(const torch::Tensor& x) {
    const torch::Tensor attended = x + self_attention(attention_norm_(x));
    return attended + feed_forward_out_(torch::relu(feed_forward_in_(feed_forward_norm_(attended))));
}

torch::Tensor EncoderLayer::self_attention(const torch::Tensor& x) {
    const std::int64_t tokens = x.size(1);
    const std::int64_t head_width = x.size(2) / heads_;
    const std::vector<torch::Tensor> parts =
        query_key_value_(x).view({-1, tokens, 3, heads_, head_width}).permute({2, 0, 3, 1, 4}).unbind(0);
    const torch::Tensor query = parts[0] / std::sqrt(static_cast<double>(head_width));
    const torch::Tensor attention = torch::matmul(query, parts[1].transpose(-2, -1)).softmax(-1);
    const torch::Tensor mixed = torch::matmul(attention, parts[2]);  // [n, heads, tokens, head_width]
    return attention_out_(mixed.transpose(1, 2).reshape({-1, tokens, heads_ * head_width}));
}

}  // namespace ddtool::models

#include "train/torch/ddmodel.hpp"

#include <cmath>
#include <vector>

namespace ddtool::train_torch {
namespace {

torch::nn::LayerNorm layer_norm(std::int64_t width) {
    return torch::nn::LayerNorm(torch::nn::LayerNormOptions({width}));
}

torch::nn::Sequential blocks_of(const network::DDModelTable& table) {
    torch::nn::Sequential blocks;
    std::int64_t channels = table.stem.channels;
    for (const network::GroupRow& group : table.groups) {
        for (std::int64_t block = 0; block < group.blocks; ++block) {
            blocks->push_back(std::make_shared<BasicBlock>(channels, group.channels, block == 0 ? group.stride : 1));
            channels = group.channels;
        }
    }
    return blocks;
}

}  // namespace

BasicBlock::BasicBlock(std::int64_t in_channels, std::int64_t out_channels, std::int64_t stride) {
    first_ = register_module("first", std::make_shared<ConvNorm>(ConvNormOptions{
                                          .in_channels = in_channels, .out_channels = out_channels, .stride = stride}));
    second_ = register_module(
        "second", std::make_shared<ConvNorm>(ConvNormOptions{
                      .in_channels = out_channels, .out_channels = out_channels, .activation = Activation::none}));
    if (in_channels != out_channels || stride != 1) {
        projection_ =
            register_module("projection", std::make_shared<ConvNorm>(ConvNormOptions{.in_channels = in_channels,
                                                                                     .out_channels = out_channels,
                                                                                     .kernel_px = 1,
                                                                                     .stride = stride,
                                                                                     .activation = Activation::none}));
    }
}

torch::Tensor BasicBlock::forward(const torch::Tensor& x) {
    const torch::Tensor skip = projection_ ? projection_->forward(x) : x;
    return torch::relu(second_->forward(first_->forward(x)) + skip);
}

EncoderLayer::EncoderLayer(const network::EncoderRow& row)
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
    const torch::Tensor mixed = torch::matmul(attention, parts[2]);  // shape [n, heads, tokens, head_width]
    return attention_out_(mixed.transpose(1, 2).reshape({-1, tokens, heads_ * head_width}));
}

DDModel::DDModel(const network::DDModelTable& table, std::int64_t size_px)
    : stem_(register_module("stem", std::make_shared<ConvNorm>(ConvNormOptions{.in_channels = 1,
                                                                               .out_channels = table.stem.channels,
                                                                               .kernel_px = table.stem.kernel_px,
                                                                               .stride = table.stem.stride,
                                                                               .activation = Activation::none}))),
      groups_(register_module("groups", blocks_of(table))),
      embedding_(register_module("embedding", torch::nn::Linear(table.groups.back().channels, table.encoder.width))),
      position_(
          register_parameter("position", torch::empty({network::token_count(table, size_px), table.encoder.width}))),
      encoder_(table.encoder.has_layer ? register_module("encoder", std::make_shared<EncoderLayer>(table.encoder))
                                       : nullptr),
      norm_(register_module("norm", torch::nn::LayerNorm(torch::nn::LayerNormOptions({table.encoder.width})))),
      head_(register_module("head", torch::nn::Linear(table.encoder.width, 2))) {
    draw_weights(*this);
    torch::nn::init::normal_(position_, 0.0, 0.02);  // as in Dosovitskiy et al. 2021
}

torch::Tensor DDModel::forward(const torch::Tensor& images) { return logits_of(head_, features(feature_map(images))); }

torch::Tensor DDModel::feature_map(const torch::Tensor& images) {
    // Max pooling and ReLU may be exchanged without any change of the result. In this order ReLU has only a quarter of
    // the values to process.
    return groups_->forward(torch::relu(torch::max_pool2d(stem_->forward(images), 3, 2, 1)));
}

torch::Tensor DDModel::features(const torch::Tensor& map) {
    // Under autocast the embedding is computed in bf16. The position is float32, and so is the sum, as layer_norm
    // requires.
    const torch::Tensor tokens = embedding_(map.flatten(2).transpose(1, 2)) + position_;
    return norm_(encoder_ ? encoder_->forward(tokens) : tokens).mean(1);
}

}  // namespace ddtool::train_torch

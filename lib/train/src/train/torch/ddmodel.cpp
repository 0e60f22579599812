#include "train/torch/ddmodel.hpp"

#include "train/torch/basic_block.hpp"

namespace ddtool::models {
namespace {

torch::nn::Sequential blocks_of(const native::DDModelTable& table) {
    torch::nn::Sequential blocks;
    std::int64_t channels = table.stem.channels;
    for (const native::GroupRow& group : table.groups) {
        for (std::int64_t block = 0; block < group.blocks; ++block) {
            blocks->push_back(std::make_shared<BasicBlock>(channels, group.channels, block == 0 ? group.stride : 1));
            channels = group.channels;
        }
    }
    return blocks;
}

}  // namespace

DDModel::DDModel(const native::DDModelTable& table, std::int64_t size_px)
    : stem_(register_module("stem", std::make_shared<ConvNorm>(ConvNormOptions{.in_channels = 1,
                                                                               .out_channels = table.stem.channels,
                                                                               .kernel_px = table.stem.kernel_px,
                                                                               .stride = table.stem.stride,
                                                                               .activation = Activation::none}))),
      groups_(register_module("groups", blocks_of(table))),
      embedding_(register_module("embedding", torch::nn::Linear(table.groups.back().channels, table.encoder.width))),
      position_(
          register_parameter("position", torch::empty({native::token_count(table, size_px), table.encoder.width}))),
      encoder_(register_module("encoder", std::make_shared<EncoderLayer>(table.encoder))),
      norm_(register_module("norm", torch::nn::LayerNorm(torch::nn::LayerNormOptions({table.encoder.width})))),
      head_(register_module("head", torch::nn::Linear(table.encoder.width, 2))) {
    draw_weights(*this);
    torch::nn::init::normal_(position_, 0.0, 0.02);  // as Dosovitskiy et al. 2021
}

torch::Tensor DDModel::forward(const torch::Tensor& images) { return logits_of(head_, features(feature_map(images))); }

torch::Tensor DDModel::feature_map(const torch::Tensor& images) {
    // The maximum and ReLU may change places; this way ReLU has a quarter of the work.
    return groups_->forward(torch::relu(torch::max_pool2d(stem_->forward(images), 3, 2, 1)));
}

torch::Tensor DDModel::features(const torch::Tensor& map) {
    // Under autocast the embedding is bf16; the sum with the position is float32 again, which layer_norm needs.
    const torch::Tensor tokens = embedding_(map.flatten(2).transpose(1, 2)) + position_;
    return norm_(encoder_->forward(tokens)).mean(1);
}

}  // namespace ddtool::models

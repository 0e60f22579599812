#include "network/dd_network.hpp"

#include <algorithm>
#include <numeric>

namespace ddtool::network {
namespace {

std::vector<BasicBlock> blocks_of(NamedWeights& weights, const DDModelTable& table, MapShape shape) {
    std::vector<BasicBlock> blocks;
    for (const GroupRow& group : table.groups) {
        for (std::int64_t block = 0; block < group.blocks; ++block) {
            blocks.emplace_back(weights, "groups." + std::to_string(blocks.size()), shape,
                                static_cast<std::size_t>(group.channels),
                                static_cast<std::size_t>(block == 0 ? group.stride : 1));
            shape = blocks.back().out_shape();
        }
    }
    return blocks;
}

AffineLayer embedding_of(NamedWeights& weights, const MapShape& map, std::size_t width) {
    return linear(weights, "embedding", {.inputs = map.channels, .outputs = width}, places(map));
}

std::size_t tokens_in(const MapShape& map) { return map.side * map.side; }

std::optional<EncoderLayer> encoder_of(NamedWeights& weights, const EncoderRow& row, std::size_t tokens) {
    if (!row.has_layer) {
        return std::nullopt;
    }
    return EncoderLayer(weights, row, tokens);
}

}  // namespace

DDNetwork::DDNetwork(NamedWeights& weights, const DDModelTable& table, std::size_t size_px)
    : position_(
          weights.take("position", {static_cast<std::size_t>(token_count(table, static_cast<std::int64_t>(size_px))),
                                    static_cast<std::size_t>(table.encoder.width)})),
      stem_(weights, table.stem, size_px),
      blocks_(blocks_of(weights, table, stem_.out_shape())),
      embedding_(embedding_of(weights, blocks_.back().out_shape(), static_cast<std::size_t>(table.encoder.width))),
      encoder_(encoder_of(weights, table.encoder, tokens_in(blocks_.back().out_shape()))),
      norm_(weights, "norm", tokens_in(blocks_.back().out_shape()), static_cast<std::size_t>(table.encoder.width)),
      head_weight_(weights.take("head.weight", {2, static_cast<std::size_t>(table.encoder.width)})),
      head_bias_(weights.take("head.bias", {2})),
      mean_(static_cast<std::size_t>(table.encoder.width)) {}

std::array<double, 2> DDNetwork::run(std::span<const float> image) {
    const float* map = stem_.run(image);
    for (BasicBlock& block : blocks_) {
        map = block.run(map);
    }
    const float* const embedded = embedding_.run(map, position_.data());
    const float* const tokens = norm_.run(encoder_ ? encoder_->run(embedded) : embedded);
    const std::size_t width = mean_.size();
    const std::size_t count = position_.size() / width;
    std::fill(mean_.begin(), mean_.end(), 0.0);
    for (std::size_t token = 0; token < count; ++token) {
        for (std::size_t i = 0; i < width; ++i) {
            mean_[i] += tokens[token * width + i] / static_cast<double>(count);
        }
    }
    const auto logit = [&](std::size_t output) {
        return std::inner_product(mean_.begin(), mean_.end(), head_weight_.data() + output * width,
                                  static_cast<double>(head_bias_[output]));
    };
    return {logit(0), logit(1)};
}

}  // namespace ddtool::network

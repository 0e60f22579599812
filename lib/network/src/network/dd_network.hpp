#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "network/basic_block.hpp"
#include "network/dd_tables.hpp"
#include "network/encoder_layer.hpp"
#include "network/stem.hpp"

namespace ddtool::network {

/// A trained network of the DD-Model's kind, which runs on one image at a time. Nothing is allocated after
/// construction.
class DDNetwork {
public:
    /// Takes all tensors of the network, under the names that train_torch::DDModel gives them. The numbers of channels
    /// and the width of a head must be multiples of block_width. Throws Error as NamedWeights does.
    DDNetwork(NamedWeights& weights, const DDModelTable& table, std::size_t size_px);

    /// The two logits of an image of size_px * size_px floats, row by row from the top.
    std::array<double, 2> run(std::span<const float> image);

private:
    std::vector<float> position_;  ///< first, so that a wrong size_px throws before anything of that size is made
    Stem stem_;
    std::vector<BasicBlock> blocks_;
    AffineLayer embedding_;
    std::optional<EncoderLayer> encoder_;  ///< empty: a network without the transformer
    LayerNorm norm_;
    std::vector<float> head_weight_;
    std::vector<float> head_bias_;
    std::vector<double> mean_;
};

}  // namespace ddtool::network

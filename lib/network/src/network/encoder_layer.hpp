#pragma once

#include "network/affine_layer.hpp"
#include "network/attention.hpp"
#include "network/dd_tables.hpp"
#include "network/layer_norm.hpp"

namespace ddtool::network {

/// One layer of a transformer encoder, the same as train_torch::EncoderLayer, with the normalisation first. Takes
/// encoder.*.
class EncoderLayer {
public:
    EncoderLayer(NamedWeights& weights, const EncoderRow& row, std::size_t tokens);

    /// From [tokens][width] to [tokens][width]. The result is the layer's own buffer, which is valid until the next
    /// run.
    const float* run(const float* in);

private:
    LayerNorm attention_norm_;
    AffineLayer query_key_value_;
    Attention attention_;
    AffineLayer attention_out_;
    LayerNorm feed_forward_norm_;
    AffineLayer feed_forward_in_;
    AffineLayer feed_forward_out_;
};

}  // namespace ddtool::network

#pragma once

#include <string>

#include "network/floats.hpp"
#include "network/named_weights.hpp"

namespace ddtool::network {

/// Layer normalisation (Ba et al. 2016) of each of `tokens` tokens, which lie in memory without gaps. Takes
/// PREFIX.weight and PREFIX.bias.
class LayerNorm {
public:
    /// width: must be a multiple of lane_count.
    LayerNorm(NamedWeights& weights, const std::string& prefix, std::size_t tokens, std::size_t width);

    /// Returns the layer's own buffer, which is valid until the next run.
    const float* run(const float* in);

private:
    std::size_t tokens_;
    Floats weight_;
    Floats bias_;
    Floats out_;
};

}  // namespace ddtool::network

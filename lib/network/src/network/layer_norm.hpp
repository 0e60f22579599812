#pragma once

#include <string>

#include "network/floats.hpp"
#include "network/named_weights.hpp"

namespace ddtool::native {

/// Layer normalisation (Ba et al. 2016) of each of `tokens` closely packed tokens. Takes PREFIX.weight and PREFIX.bias.
class LayerNorm {
public:
    /// width: a multiple of lane_count.
    LayerNorm(NamedWeights& weights, const std::string& prefix, std::size_t tokens, std::size_t width);

    /// The layer's own buffer, good until the next run.
    const float* run(const float* in);

private:
    std::size_t tokens_;
    Floats weight_;
    Floats bias_;
    Floats out_;
};

}  // namespace ddtool::native

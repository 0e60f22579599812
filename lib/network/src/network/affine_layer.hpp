#pragma once

#include <string>
#include <vector>

#include "network/floats.hpp"
#include "network/named_weights.hpp"
#include "network/product.hpp"

namespace ddtool::network {

/// Weighted sums, a bias and optionally ReLU, at every point of a map or for every token.
class AffineLayer {
public:
    struct Points {
        std::vector<std::size_t> from;
        Window window;
        std::vector<std::size_t> to;
        std::size_t out_size = 0;  ///< of the buffer that `to` points into
    };
    struct Weights {
        Floats blocks;  ///< laid out as WeightBlocks, without gaps
        Floats bias;    ///< [outputs]
    };

    AffineLayer(Points points, Weights weights, bool relu);

    /// Returns the layer's own buffer, which is valid until the next run. `skip`, in the same layout, is added before
    /// ReLU.
    const float* run(const float* in, const float* skip = nullptr);

private:
    Points points_;
    Weights weights_;
    bool relu_;
    Floats out_;
};

struct LinearRow {
    std::size_t inputs = 0;
    std::size_t outputs = 0;
    bool relu = false;
};

/// Linear layer from tokens that start at the offsets `from` to tokens without gaps. Takes PREFIX.weight and
/// PREFIX.bias.
AffineLayer linear(NamedWeights& weights, const std::string& prefix, const LinearRow& row,
                   std::vector<std::size_t> from);

/// The offsets of `count` tokens of that width without gaps.
std::vector<std::size_t> packed_tokens(std::size_t count, std::size_t width);

}  // namespace ddtool::network

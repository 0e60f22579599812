#pragma once

#include <string>
#include <vector>

#include "network/floats.hpp"
#include "network/named_weights.hpp"
#include "network/product.hpp"

namespace ddtool::native {

/// Weighted sums, a bias and perhaps ReLU, at every point of a map or every token.
class AffineLayer {
public:
    struct Points {
        std::vector<std::size_t> from;
        Window window;
        std::vector<std::size_t> to;
        std::size_t out_size = 0;  ///< of the buffer that `to` points into
    };
    struct Weights {
        Floats blocks;  ///< as WeightBlocks, closely packed
        Floats bias;    ///< [outputs]
    };

    AffineLayer(Points points, Weights weights, bool relu);

    /// The layer's own buffer, good until the next run. `skip`, laid out so too, is added before ReLU.
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

/// Linear layer from tokens that start at `from` to tokens closely packed. Takes PREFIX.weight and PREFIX.bias.
AffineLayer linear(NamedWeights& weights, const std::string& prefix, const LinearRow& row,
                   std::vector<std::size_t> from);

/// Where `count` tokens lie that are closely packed.
std::vector<std::size_t> packed_tokens(std::size_t count, std::size_t width);

}  // namespace ddtool::native

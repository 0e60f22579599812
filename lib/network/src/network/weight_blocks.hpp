#pragma once

#include "network/floats.hpp"
#include "network/product.hpp"

namespace ddtool::network {

/// Lays out the weights weight_of(output, input) as WeightBlocks without gaps. `outputs` must be a multiple of
/// block_width.
template <typename WeightOf>
Floats packed_weights(std::size_t outputs, std::size_t inputs, const WeightOf& weight_of) {
    Floats blocks(outputs * inputs);
    for (std::size_t output = 0; output < outputs; ++output) {
        float* const block = blocks.data() + output / block_width * inputs * block_width;
        for (std::size_t input = 0; input < inputs; ++input) {
            block[input * block_width + output % block_width] = weight_of(output, input);
        }
    }
    return blocks;
}

}  // namespace ddtool::network

#pragma once

#include <string>
#include <vector>

#include "network/floats.hpp"
#include "network/named_weights.hpp"

namespace ddtool::network {

/// A kernel [outputs][inputs][kernel_px][kernel_px] without bias, combined with the batch normalisation after it (Ioffe
/// and Szegedy 2015). With fixed statistics, the normalisation is a factor and a shift for each output.
struct FoldedKernel {
    std::vector<float> values;
    Floats bias;  ///< [outputs]
};

/// Takes PREFIX.conv.weight and PREFIX.norm.* from `weights`.
FoldedKernel folded_kernel(NamedWeights& weights, const std::string& prefix, std::size_t outputs, std::size_t inputs,
                           std::size_t kernel_px);

}  // namespace ddtool::network

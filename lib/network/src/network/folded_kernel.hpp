#pragma once

#include <string>
#include <vector>

#include "network/floats.hpp"
#include "network/named_weights.hpp"

namespace ddtool::native {

/// A kernel [outputs][inputs][kernel_px][kernel_px] without bias, and the batch normalisation after it (Ioffe and
/// Szegedy 2015), as one: where the statistics are fixed, the latter is a factor and a shift for each output.
struct FoldedKernel {
    std::vector<float> values;
    Floats bias;  ///< [outputs]
};

/// Takes PREFIX.conv.weight and PREFIX.norm.*.
FoldedKernel folded_kernel(NamedWeights& weights, const std::string& prefix, std::size_t outputs, std::size_t inputs,
                           std::size_t kernel_px);

}  // namespace ddtool::native

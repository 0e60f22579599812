#pragma once

#include <vector>

#include "network/folded_kernel.hpp"
#include "network/map_shape.hpp"

namespace ddtool::network {

/// A 3x3 convolution of stride 1 by the minimal filtering F(4x4, 3x3) of Lavin and Gray 2016 (section 4.3): sixteen
/// outputs take 36 products instead of 144. The rounding errors of its transforms are about five times those of the
/// direct computation.
class WinogradLayer {
public:
    /// The side of the input must be a multiple of 4, and that of the kernel 3.
    WinogradLayer(const MapShape& in, FoldedKernel kernel, bool relu);

    /// The same as AffineLayer::run().
    const float* run(const float* in, const float* skip = nullptr);

private:
    MapShape in_shape_;
    MapShape out_shape_;
    std::vector<std::size_t> sources_;  ///< offsets of the tiles in the transformed inputs
    std::vector<std::size_t> targets_;  ///< offsets of the tiles in the products
    Floats kernel_;                     ///< 36 times WeightBlocks
    Floats bias_;
    bool relu_;
    Floats inputs_;    ///< [36][tiles][inputs]
    Floats products_;  ///< [36][tiles][outputs]
    Floats out_;
};

}  // namespace ddtool::network

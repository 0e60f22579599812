#pragma once

#include <vector>

#include "network/folded_kernel.hpp"
#include "network/map_shape.hpp"

namespace ddtool::native {

/// A 3x3 convolution of stride 1 by the minimal filtering F(4x4, 3x3) of Lavin and Gray 2016 (section 4.3): sixteen
/// outputs come from 36 products instead of 144. Its transforms round some five times as coarsely as the definition.
class WinogradLayer {
public:
    /// The input's side must be a multiple of 4; the kernel's, 3.
    WinogradLayer(const MapShape& in, FoldedKernel kernel, bool relu);

    /// As AffineLayer's.
    const float* run(const float* in, const float* skip = nullptr);

private:
    MapShape in_shape_;
    MapShape out_shape_;
    std::vector<std::size_t> sources_;  ///< of the tiles, among transformed inputs
    std::vector<std::size_t> targets_;  ///< of the tiles, among products
    Floats kernel_;                     ///< [36] of WeightBlocks
    Floats bias_;
    bool relu_;
    Floats inputs_;    ///< [36][tiles][inputs]
    Floats products_;  ///< [36][tiles][outputs]
    Floats out_;
};

}  // namespace ddtool::native

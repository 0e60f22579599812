#pragma once

#include <span>

#include "network/dd_tables.hpp"
#include "network/folded_kernel.hpp"
#include "network/map_shape.hpp"

namespace ddtool::network {

/// The network's first convolution with its batch normalisation, 3x3 max pooling of stride 2, and ReLU. An image of
/// particles is nearly empty, so it adds each marked pixel to the few outputs that the pixel affects.
class Stem {
public:
    /// Takes stem.conv.weight and stem.norm.*.
    Stem(NamedWeights& weights, const StemRow& row, std::size_t size_px);

    [[nodiscard]] const MapShape& out_shape() const { return out_shape_; }
    /// image: size_px * size_px floats, row by row from the top. Returns the stem's own buffer, which is valid until
    /// the next run.
    const float* run(std::span<const float> image);

private:
    void add_pixel(std::size_t y, std::size_t x, float value);

    std::size_t size_px_;
    std::size_t kernel_px_;
    std::size_t stride_;
    MapShape map_shape_;
    MapShape out_shape_;
    Floats kernel_;  // [kernel_px][kernel_px][channels]
    Floats bias_;
    Floats map_;
    Floats out_;
};

}  // namespace ddtool::network

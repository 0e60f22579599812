#pragma once

#include <variant>

#include "network/affine_layer.hpp"
#include "network/winograd_layer.hpp"

namespace ddtool::network {

struct ConvolutionRow {
    std::size_t channels = 0;
    std::size_t kernel_px = 3;  ///< 3 or 1, padded so that stride 1 keeps the size
    std::size_t stride = 1;
    bool relu = false;
};

MapShape shape_after(const ConvolutionRow& row, const MapShape& in);

/// Convolution and batch normalisation as one layer, computed in the way that costs least. Takes the tensors that
/// folded_kernel() takes.
class Convolution {
public:
    Convolution(NamedWeights& weights, const std::string& prefix, const MapShape& in, const ConvolutionRow& row);

    /// The same as AffineLayer::run().
    const float* run(const float* in, const float* skip = nullptr) {
        return std::visit([&](auto& layer) { return layer.run(in, skip); }, layer_);
    }

private:
    std::variant<AffineLayer, WinogradLayer> layer_;
};

}  // namespace ddtool::network

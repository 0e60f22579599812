#pragma once

#include <optional>

#include "network/convolution.hpp"

namespace ddtool::network {

/// Residual block, the same as train_torch::BasicBlock (He et al. 2016). Takes PREFIX.first, .second and, where the
/// shape changes, .projection.
class BasicBlock {
public:
    BasicBlock(NamedWeights& weights, const std::string& prefix, const MapShape& in, std::size_t channels,
               std::size_t stride);

    [[nodiscard]] const MapShape& out_shape() const { return out_shape_; }
    /// Returns the block's own buffer, which is valid until the next run.
    const float* run(const float* in) { return second_.run(first_.run(in), projection_ ? projection_->run(in) : in); }

private:
    MapShape out_shape_;
    Convolution first_;
    Convolution second_;
    std::optional<Convolution> projection_;
};

}  // namespace ddtool::network

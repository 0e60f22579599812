#include "network/basic_block.hpp"

namespace ddtool::network {
namespace {

ConvolutionRow first_row(std::size_t channels, std::size_t stride) {
    return {.channels = channels, .stride = stride, .relu = true};
}

}  // namespace

BasicBlock::BasicBlock(NamedWeights& weights, const std::string& prefix, const MapShape& in, std::size_t channels,
                       std::size_t stride)
    : out_shape_(shape_after(first_row(channels, stride), in)),
      first_(weights, prefix + ".first", in, first_row(channels, stride)),
      second_(weights, prefix + ".second", out_shape_, {.channels = channels, .relu = true}) {
    if (in.channels != channels || stride != 1) {
        projection_.emplace(weights, prefix + ".projection", in,
                            ConvolutionRow{.channels = channels, .kernel_px = 1, .stride = stride});
    }
}

}  // namespace ddtool::network

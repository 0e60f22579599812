#include "network/convolution.hpp"

#include "network/weight_blocks.hpp"

namespace ddtool::network {
namespace {

Floats packed_kernel(const FoldedKernel& kernel, std::size_t outputs, std::size_t inputs, std::size_t kernel_px) {
    const std::size_t area = kernel_px * kernel_px;
    return packed_weights(outputs, area * inputs, [&](std::size_t output, std::size_t index) {
        return kernel.values[(output * inputs + index % inputs) * area + index / inputs];
    });
}

AffineLayer direct(FoldedKernel kernel, const MapShape& in, const ConvolutionRow& row) {
    const MapShape out = shape_after(row, in);
    std::vector<std::size_t> from = places(in, row.stride);
    for (std::size_t& start : from) {
        start -= row.kernel_px / 2 * (in.row_step() + in.channels);
    }
    return {{.from = std::move(from),
             .window = {.rows = row.kernel_px, .length = row.kernel_px * in.channels, .row_step = in.row_step()},
             .to = places(out),
             .out_size = out.size()},
            {packed_kernel(kernel, row.channels, in.channels, row.kernel_px), std::move(kernel.bias)},
            row.relu};
}

/// With fewer input channels than this, the Winograd transforms cost as much time as their fewer multiplications save.
constexpr std::size_t least_winograd_inputs = 32;

bool winograd_pays(const MapShape& in, const ConvolutionRow& row) {
    return row.kernel_px == 3 && row.stride == 1 && in.side % 4 == 0 && in.channels >= least_winograd_inputs;
}

std::variant<AffineLayer, WinogradLayer> layer_of(FoldedKernel kernel, const MapShape& in, const ConvolutionRow& row) {
    if (winograd_pays(in, row)) {
        return WinogradLayer(in, std::move(kernel), row.relu);
    }
    return direct(std::move(kernel), in, row);
}

}  // namespace

MapShape shape_after(const ConvolutionRow& row, const MapShape& in) {
    return {strided(in.side, row.stride), row.channels};
}

Convolution::Convolution(NamedWeights& weights, const std::string& prefix, const MapShape& in,
                         const ConvolutionRow& row)
    : layer_(layer_of(folded_kernel(weights, prefix, row.channels, in.channels, row.kernel_px), in, row)) {}

}  // namespace ddtool::network

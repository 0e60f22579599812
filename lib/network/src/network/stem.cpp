#include "network/stem.hpp"

#include <algorithm>

#include "base/lanes.hpp"

namespace ddtool::network {
namespace {

DDTOOL_VECTORISED void fill(Floats& map, const MapShape& shape, const Floats& bias) {
    for (std::size_t y = 0; y < shape.side; ++y) {
        for (std::size_t x = 0; x < shape.side; ++x) {
            std::copy(bias.begin(), bias.end(), map.begin() + static_cast<std::ptrdiff_t>(shape.at(y, x)));
        }
    }
}

/// The largest value in the window of 3x3 places, but at least 0, lane by lane. This is max pooling after ReLU in one
/// step: because ReLU gives no negative value, the zeros of the border change nothing.
inline __attribute__((always_inline)) void pool(const float* window, const MapShape& shape, float* out) {
    Lanes most{};
    for (std::size_t y = 0; y < 3; ++y) {
        for (std::size_t x = 0; x < 3; ++x) {
            Lanes value;
            load(value, window + y * shape.row_step() + x * shape.channels);
            most = value > most ? value : most;
        }
    }
    store(out, most);
}

DDTOOL_VECTORISED void pool_map(const Floats& map, const MapShape& shape, Floats& out, const MapShape& out_shape) {
    for (std::size_t y = 0; y < out_shape.side; ++y) {
        for (std::size_t x = 0; x < out_shape.side; ++x) {
            const float* const window = map.data() + shape.at(2 * y, 2 * x) - shape.row_step() - shape.channels;
            for (std::size_t channel = 0; channel < shape.channels; channel += lane_count) {
                pool(window + channel, shape, out.data() + out_shape.at(y, x) + channel);
            }
        }
    }
}

}  // namespace

Stem::Stem(NamedWeights& weights, const StemRow& row, std::size_t size_px)
    : size_px_(size_px),
      kernel_px_(static_cast<std::size_t>(row.kernel_px)),
      stride_(static_cast<std::size_t>(row.stride)),
      map_shape_{strided(size_px, stride_), static_cast<std::size_t>(row.channels)},
      out_shape_{strided(map_shape_.side, 2), map_shape_.channels},
      map_(map_shape_.size(), 0.0F),
      out_(out_shape_.size(), 0.0F) {
    const std::size_t channels = map_shape_.channels;
    const std::size_t area = kernel_px_ * kernel_px_;
    FoldedKernel folded = folded_kernel(weights, "stem", channels, 1, kernel_px_);
    kernel_.resize(area * channels);
    for (std::size_t index = 0; index < kernel_.size(); ++index) {
        kernel_[index] = folded.values[index % channels * area + index / channels];
    }
    bias_ = std::move(folded.bias);
}

const float* Stem::run(std::span<const float> image) {
    fill(map_, map_shape_, bias_);
    for (std::size_t y = 0; y < size_px_; ++y) {
        for (std::size_t x = 0; x < size_px_; ++x) {
            if (const float value = image[y * size_px_ + x]; value != 0.0F) {
                add_pixel(y, x, value);
            }
        }
    }
    pool_map(map_, map_shape_, out_, out_shape_);
    return out_.data();
}

/// Adds the contribution of one pixel to all outputs that see it. The window of the output (oy, ox) begins at the pixel
/// row oy * stride - kernel_px / 2, so the pixel row y is row y + kernel_px / 2 - oy * stride of that window. The same
/// holds for the columns.
void Stem::add_pixel(std::size_t y, std::size_t x, float value) {
    const std::size_t bottom = y + kernel_px_ / 2;
    const std::size_t right = x + kernel_px_ / 2;
    const auto first = [&](std::size_t end) { return end < kernel_px_ ? 0 : (end - kernel_px_) / stride_ + 1; };
    const auto last = [&](std::size_t end) { return std::min(end / stride_, map_shape_.side - 1); };
    for (std::size_t oy = first(bottom); oy <= last(bottom); ++oy) {
        for (std::size_t ox = first(right); ox <= last(right); ++ox) {
            const std::size_t place = (bottom - oy * stride_) * kernel_px_ + (right - ox * stride_);
            const float* const weight = kernel_.data() + place * map_shape_.channels;
            float* const out = map_.data() + map_shape_.at(oy, ox);
            for (std::size_t channel = 0; channel < map_shape_.channels; ++channel) {
                out[channel] += value * weight[channel];
            }
        }
    }
}

}  // namespace ddtool::network

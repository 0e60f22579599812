#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "ddtool/network/linear_mapping.hpp"

namespace ddtool {

/// The paper's Gaussian augmentation, eq. (Gaussian): each particle adds G to the 5 x 5 pixels around its own, and a
/// pixel whose sum exceeds the threshold is marked. Sums are integers, so the order of the particles has no effect, and
/// they stop growing beyond the threshold, so that no number of particles makes them overflow. An object may be used by
/// one thread at a time.
class GaussianAugmentation {
public:
    GaussianAugmentation(double sigma_px, double threshold, std::size_t size_px);

    /// Sets the marked pixels to `marked` and leaves the others as they are. `pixels` has size_px * size_px pixels, row
    /// by row from the top; all places must lie in the image.
    template <typename Pixel>
    void mark(std::span<const ImagePixel> places, std::span<Pixel> pixels, Pixel marked) {
        for (const ImagePixel& place : places) {
            for_each_neighbour(place, [&](std::uint32_t& sum, std::size_t row, std::size_t column) {
                sum = std::min(sum + kernel_[row * side_px + column], enough);
            });
        }
        for (const ImagePixel& place : places) {
            for_each_neighbour(place, [&](std::uint32_t& sum, std::size_t row, std::size_t column) {
                // Beyond the image's edges the subtraction wraps round to a large number.
                const std::size_t image_row = place.row + row - reach_px;
                const std::size_t image_column = place.column + column - reach_px;
                if (sum > threshold_sum && image_row < size_px_ && image_column < size_px_) {
                    pixels[image_row * size_px_ + image_column] = marked;
                }
                sum = 0;
            });
        }
    }

private:
    static constexpr std::size_t reach_px = 2;
    static constexpr std::size_t side_px = 2 * reach_px + 1;
    static constexpr std::uint32_t threshold_sum = 1U << 20U;
    static constexpr std::uint32_t enough = 2 * threshold_sum;

    /// The sums include a margin around the image, so that every place has all its neighbours.
    template <typename Visit>
    void for_each_neighbour(const ImagePixel& place, Visit&& visit) {
        const std::size_t stride = size_px_ + 2 * reach_px;
        for (std::size_t row = 0; row < side_px; ++row) {
            std::uint32_t* const sums = &sums_[(place.row + row) * stride + place.column];
            for (std::size_t column = 0; column < side_px; ++column) {
                visit(sums[column], row, column);
            }
        }
    }

    std::array<std::uint32_t, side_px * side_px> kernel_{};  ///< G in units of threshold / threshold_sum
    std::size_t size_px_;
    std::vector<std::uint32_t> sums_;  ///< zero between calls; (size_px + 2 reach_px) squared
};

}  // namespace ddtool

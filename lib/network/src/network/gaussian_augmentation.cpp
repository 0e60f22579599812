#include "ddtool/network/gaussian_augmentation.hpp"

#include <cmath>
#include <numbers>

namespace ddtool {

GaussianAugmentation::GaussianAugmentation(double sigma_px, double threshold, std::size_t size_px)
    : size_px_(size_px), sums_((size_px + 2 * reach_px) * (size_px + 2 * reach_px), 0) {
    const double variance = sigma_px * sigma_px;
    for (std::size_t index = 0; index < kernel_.size(); ++index) {
        const std::size_t row = index / side_px;
        const std::size_t column = index % side_px;
        const double dx = static_cast<double>(column) - reach_px;
        const double dy = static_cast<double>(row) - reach_px;
        const double g = std::exp(-(dx * dx + dy * dy) / (2.0 * variance)) / (2.0 * std::numbers::pi * variance);
        kernel_[index] =
            static_cast<std::uint32_t>(std::min<double>(enough, std::round(g / threshold * threshold_sum)));
    }
}

}  // namespace ddtool

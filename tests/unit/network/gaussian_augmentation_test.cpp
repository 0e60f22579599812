#include "ddtool/network/gaussian_augmentation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "ddtool/base/random.hpp"

namespace ddtool {
namespace {

constexpr std::size_t augmented_size_px = 40;
constexpr std::uint8_t marked = 1;
using Pixels = std::vector<std::uint8_t>;

Pixels mark(const std::vector<ImagePixel>& places, double sigma_px, double threshold) {
    Pixels pixels(augmented_size_px * augmented_size_px, 0);
    GaussianAugmentation(sigma_px, threshold, augmented_size_px).mark(std::span(places), std::span(pixels), marked);
    return pixels;
}

auto marked_by(std::size_t particles) {
    const ImageSettings settings;
    const Pixels pixels =
        mark(std::vector<ImagePixel>(particles, {20, 20}), settings.gaussian_sigma_px, settings.gaussian_threshold);
    return std::count(pixels.begin(), pixels.end(), marked);
}

TEST(GaussianAugmentation, MarksMoreWhereParticlesOverlap) {
    EXPECT_EQ(marked_by(1), 13);
    EXPECT_EQ(marked_by(2), 21);
    EXPECT_EQ(marked_by(7), 25);
}

TEST(GaussianAugmentation, NeverUnmarksHoweverManyOverlap) {
    for (const std::size_t particles : std::array<std::size_t, 4>{100, 2048, 4096, 100'000}) {
        EXPECT_EQ(marked_by(particles), 25) << particles << " particles";
    }
}

/// The equation without any optimisation: for every pixel, the sum over all particles within reach.
Pixels mark_by_the_equation(const std::vector<ImagePixel>& places, double sigma_px, double threshold) {
    const double variance = sigma_px * sigma_px;
    Pixels pixels(augmented_size_px * augmented_size_px, 0);
    for (std::size_t index = 0; index < pixels.size(); ++index) {
        const std::size_t row = index / augmented_size_px;
        const std::size_t column = index % augmented_size_px;
        double sum = 0.0;
        for (const ImagePixel& place : places) {
            const double dy = std::abs(static_cast<double>(row) - static_cast<double>(place.row));
            const double dx = std::abs(static_cast<double>(column) - static_cast<double>(place.column));
            if (std::max(dx, dy) <= 2.0) {
                sum += std::exp(-(dx * dx + dy * dy) / (2.0 * variance)) / (2.0 * std::numbers::pi * variance);
            }
        }
        pixels[index] = sum > threshold ? marked : 0;
    }
    return pixels;
}

TEST(GaussianAugmentation, IsTheEquationUpToTheImagesEdges) {
    for (std::uint64_t seed = 0; seed < 30; ++seed) {
        RandomStream random({seed});
        std::vector<ImagePixel> places(10 + random.index(300));
        for (ImagePixel& place : places) {
            place = {random.index(augmented_size_px), random.index(augmented_size_px)};
        }
        const double sigma_px = random.uniform(0.5, 3.0);
        const double threshold = random.uniform(0.002, 0.3);
        EXPECT_EQ(mark(places, sigma_px, threshold), mark_by_the_equation(places, sigma_px, threshold))
            << "seed " << seed;
    }
}

TEST(GaussianAugmentation, ForgetsTheImageBefore) {
    GaussianAugmentation augmentation(1.0, 0.1, augmented_size_px);
    const std::vector<ImagePixel> lone{{0, 39}};
    for (int image = 0; image < 3; ++image) {
        Pixels pixels(augmented_size_px * augmented_size_px, 0);
        augmentation.mark(std::span(lone), std::span(pixels), marked);
        EXPECT_EQ(pixels, mark(lone, 1.0, 0.1));
    }
}

}  // namespace
}  // namespace ddtool

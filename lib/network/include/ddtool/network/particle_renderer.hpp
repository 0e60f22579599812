#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "ddtool/network/gaussian_augmentation.hpp"
#include "ddtool/network/image_settings.hpp"
#include "ddtool/network/linear_mapping.hpp"
#include "ddtool/network/particle_image.hpp"
#include "ddtool/swarm/particle_snapshot.hpp"

namespace ddtool {

/// Draws swarms as images. Training and SLAM both use it, so that networks always get the same input (docs/imaging.md).
/// It keeps its working memory, so that after the first call nothing is allocated; each thread needs its own renderer.
class ParticleRenderer {
public:
    /// Throws UsageError naming the setting for an invalid value.
    explicit ParticleRenderer(const ImageSettings& settings);

    [[nodiscard]] const ImageSettings& settings() const { return settings_; }

    /// Particles that are not finite or lie outside of the canvas are not drawn. Without any particle the image is
    /// empty.
    void render(std::span<const SnapshotParticle> particles, ParticleImage& image);
    /// The same into memory of the caller, such as one image of a batch: size_px * size_px pixels, row by row from the
    /// top. Bytes have the values of ParticleImage, floats are 0 or 1. Throws Error for memory of another size.
    void render(std::span<const SnapshotParticle> particles, std::span<std::uint8_t> pixels);
    void render(std::span<const SnapshotParticle> particles, std::span<float> pixels);

private:
    template <typename Pixel>
    void draw(std::span<const SnapshotParticle> particles, std::span<Pixel> pixels, Pixel empty, Pixel marked);

    ImageSettings settings_;
    std::optional<GaussianAugmentation> augmentation_;
    std::vector<Point2> points_;
    std::vector<ImagePixel> places_;
};

}  // namespace ddtool

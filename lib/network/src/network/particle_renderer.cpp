#include "ddtool/network/particle_renderer.hpp"

#include <algorithm>
#include <string>

#include "ddtool/base/error.hpp"

namespace ddtool {

ParticleRenderer::ParticleRenderer(const ImageSettings& settings) : settings_(settings) {
    expect_valid(settings);
    if (settings.gaussian_augmentation) {
        augmentation_.emplace(settings.gaussian_sigma_px, settings.gaussian_threshold, settings.size_px);
    }
}

void ParticleRenderer::render(std::span<const SnapshotParticle> particles, ParticleImage& image) {
    image.size_px = settings_.size_px;
    image.pixels.resize(settings_.size_px * settings_.size_px);
    render(particles, std::span<std::uint8_t>(image.pixels));
}

void ParticleRenderer::render(std::span<const SnapshotParticle> particles, std::span<std::uint8_t> pixels) {
    draw(particles, pixels, ParticleImage::empty, ParticleImage::marked);
}

void ParticleRenderer::render(std::span<const SnapshotParticle> particles, std::span<float> pixels) {
    draw(particles, pixels, 0.0F, 1.0F);
}

template <typename Pixel>
void ParticleRenderer::draw(std::span<const SnapshotParticle> particles, std::span<Pixel> pixels, Pixel empty,
                            Pixel marked) {
    if (pixels.size() != settings_.size_px * settings_.size_px) {
        throw Error("render: memory for " + std::to_string(pixels.size()) + " pixels, expected " +
                    std::to_string(settings_.size_px * settings_.size_px));
    }
    coordinates(particles, settings_, points_);
    map_to_pixels(points_, canvas_side_m(particles, settings_), settings_, places_);
    std::fill(pixels.begin(), pixels.end(), empty);
    if (augmentation_) {
        augmentation_->mark(std::span<const ImagePixel>(places_), pixels, marked);
        return;
    }
    for (const ImagePixel& place : places_) {
        pixels[place.row * settings_.size_px + place.column] = marked;
    }
}

}  // namespace ddtool

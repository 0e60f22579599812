#pragma once

#include <cstddef>
#include <filesystem>

#include "ddtool/network/particle_image.hpp"

namespace ddtool {

/// Writes the image as a grey PNG. Throws Error naming the file.
void write_image_file(const std::filesystem::path& path, const ParticleImage& image);

/// Reads one back, pixel for pixel: with write_image_file the paper's way of handing an image to the network through a
/// file. Throws Error naming the file for one that is damaged or not a grey picture of that size.
ParticleImage read_image_file(const std::filesystem::path& path, std::size_t size_px);

}  // namespace ddtool

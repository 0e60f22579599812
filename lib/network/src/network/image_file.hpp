#pragma once

#include <cstddef>
#include <filesystem>

#include "ddtool/network/particle_image.hpp"

namespace ddtool {

/// Writes the image as a grey PNG. Throws Error naming the file if that fails.
void write_image_file(const std::filesystem::path& path, const ParticleImage& image);

/// Reads such an image back, pixel for pixel. Together with write_image_file() this is the paper's way of passing an
/// image to the network through a file. Throws Error naming the file if it is damaged or not a grey image of that size.
ParticleImage read_image_file(const std::filesystem::path& path, std::size_t size_px);

}  // namespace ddtool

#include "network/image_file.hpp"

#include "system/png_file.hpp"

namespace ddtool {

void write_image_file(const std::filesystem::path& path, const ParticleImage& image) {
    write_png(path, {.width_px = image.size_px, .height_px = image.size_px, .channels = 1, .pixels = image.pixels});
}

ParticleImage read_image_file(const std::filesystem::path& path, std::size_t size_px) {
    return {size_px, read_grey_png(path, size_px, size_px)};
}

}  // namespace ddtool

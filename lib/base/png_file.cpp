#include "base/png_file.hpp"

#include <png.h>

#include <string>

#include "base/atomic_file.hpp"
#include "base/error.hpp"

namespace ddtool {

void write_png(const std::filesystem::path& path, const PixelView& image) {
    if (image.pixels.size() != image.width_px * image.height_px * image.channels) {
        throw Error(path.string() + ": image of " + std::to_string(image.pixels.size()) + " bytes, expected " +
                    std::to_string(image.width_px * image.height_px * image.channels));
    }
    png_image header{};
    header.version = PNG_IMAGE_VERSION;
    header.width = static_cast<png_uint_32>(image.width_px);
    header.height = static_cast<png_uint_32>(image.height_px);
    header.format = image.channels == 1 ? PNG_FORMAT_GRAY : PNG_FORMAT_BGR;
    AtomicFile file(path);
    if (png_image_write_to_file(&header, file.part().c_str(), 0, image.pixels.data(), 0, nullptr) == 0) {
        throw Error(path.string() + ": cannot write as PNG: " + std::string(header.message));
    }
    file.commit();
}

}  // namespace ddtool

#include "base/png_file.hpp"

#include <png.h>

#include <string>
#include <string_view>

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
    std::string bytes(PNG_IMAGE_PNG_SIZE_MAX(header), '\0');
    png_alloc_size_t size = bytes.size();
    if (png_image_write_to_memory(&header, bytes.data(), &size, 0, image.pixels.data(), 0, nullptr) == 0) {
        throw Error(path.string() + ": cannot encode as PNG: " + std::string(header.message));
    }
    write_file(path, std::string_view(bytes.data(), size));
}

}  // namespace ddtool

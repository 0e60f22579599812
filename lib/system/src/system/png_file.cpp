#include "system/png_file.hpp"

#include <png.h>

#include <string>

#include "ddtool/base/error.hpp"
#include "system/atomic_file.hpp"

namespace ddtool {

namespace {

std::string encoded(const PixelView& image, const std::string& name) {
    if (image.pixels.size() != image.width_px * image.height_px * image.channels) {
        throw Error(name + ": image of " + std::to_string(image.pixels.size()) + " bytes, expected " +
                    std::to_string(image.width_px * image.height_px * image.channels));
    }
    png_image header{};
    header.version = PNG_IMAGE_VERSION;
    header.width = static_cast<png_uint_32>(image.width_px);
    header.height = static_cast<png_uint_32>(image.height_px);
    header.format = image.channels == 1 ? PNG_FORMAT_GRAY : PNG_FORMAT_BGR;
    png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(header);
    std::string bytes(size, '\0');
    if (png_image_write_to_memory(&header, bytes.data(), &size, 0, image.pixels.data(), 0, nullptr) == 0) {
        throw Error(name + ": cannot be made a PNG: " + std::string(header.message));
    }
    bytes.resize(size);
    bytes.shrink_to_fit();
    return bytes;
}

}  // namespace

std::string png_bytes(const PixelView& image) { return encoded(image, "picture"); }

void write_png(const std::filesystem::path& path, const PixelView& image) {
    write_file(path, encoded(image, path.string()));
}

std::vector<std::uint8_t> read_grey_png(const std::filesystem::path& path, std::size_t width_px,
                                        std::size_t height_px) {
    png_image header{};
    header.version = PNG_IMAGE_VERSION;
    if (png_image_begin_read_from_file(&header, path.c_str()) == 0) {
        throw Error(path.string() + ": cannot read as PNG: " + std::string(header.message));
    }
    if (header.width != width_px || header.height != height_px || header.format != PNG_FORMAT_GRAY) {
        png_image_free(&header);
        throw Error(path.string() + ": " + std::to_string(header.width) + " x " + std::to_string(header.height) +
                    " pixels" + (header.format == PNG_FORMAT_GRAY ? "" : ", not 8-bit grey") + "; expected " +
                    std::to_string(width_px) + " x " + std::to_string(height_px) + " of 8-bit grey");
    }
    std::vector<std::uint8_t> pixels(width_px * height_px);
    if (png_image_finish_read(&header, nullptr, pixels.data(), 0, nullptr) == 0) {
        throw Error(path.string() + ": damaged PNG: " + std::string(header.message));
    }
    return pixels;
}

}  // namespace ddtool

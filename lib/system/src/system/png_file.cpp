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

GreyPicture read_png(const std::filesystem::path& path, std::size_t most_pixels) {
    png_image header{};
    header.version = PNG_IMAGE_VERSION;
    if (png_image_begin_read_from_file(&header, path.c_str()) == 0) {
        throw Error(path.string() + ": cannot read as PNG: " + std::string(header.message));
    }
    if (std::size_t{header.width} * header.height > most_pixels) {
        png_image_free(&header);
        throw Error(path.string() + ": " + std::to_string(header.width) + " x " + std::to_string(header.height) +
                    " pixels; expected at most " + std::to_string(most_pixels) + " in all");
    }
    header.format = PNG_FORMAT_RGBA;
    GreyPicture picture{.width_px = header.width, .height_px = header.height, .grey = {}, .opacity = {}};
    std::vector<std::uint8_t> colours(PNG_IMAGE_SIZE(header));
    if (png_image_finish_read(&header, nullptr, colours.data(), 0, nullptr) == 0) {
        throw Error(path.string() + ": damaged PNG: " + std::string(header.message));
    }
    constexpr std::size_t channels = 4;
    bool transparent = false;
    for (std::size_t i = 0; i < colours.size(); i += channels) {
        picture.grey.push_back(static_cast<std::uint8_t>((colours[i] + colours[i + 1] + colours[i + 2]) / 3));
        picture.opacity.push_back(colours[i + 3]);
        transparent = transparent || colours[i + 3] != 255;
    }
    if (!transparent) {
        picture.opacity.clear();
    }
    return picture;
}

}  // namespace ddtool

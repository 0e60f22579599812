#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>

namespace ddtool {

/// 8-bit pixels, row by row from the top, no padding: 1 channel grey, 3 BGR (OpenCV's order).
struct PixelView {
    std::size_t width_px = 0;
    std::size_t height_px = 0;
    std::size_t channels = 1;
    std::span<const std::uint8_t> pixels;  ///< width_px * height_px * channels bytes
};

/// Writes a PNG through libpng: OpenCV's own writer would pull a geographic library and 50 MB of memory into every
/// command. Written beside and renamed. Throws Error naming the file.
void write_png(const std::filesystem::path& path, const PixelView& image);

}  // namespace ddtool

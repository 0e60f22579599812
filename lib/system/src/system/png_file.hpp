#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace ddtool {

/// 8-bit pixels, row by row from the top, no padding: 1 channel grey, 3 BGR (OpenCV's order).
struct PixelView {
    std::size_t width_px = 0;
    std::size_t height_px = 0;
    std::size_t channels = 1;
    std::span<const std::uint8_t> pixels;  ///< width_px * height_px * channels bytes
};

/// The pixels of an OpenCV matrix that lies in memory without gaps.
template <class Matrix>
PixelView pixels_of(const Matrix& matrix) {
    return {.width_px = static_cast<std::size_t>(matrix.cols),
            .height_px = static_cast<std::size_t>(matrix.rows),
            .channels = static_cast<std::size_t>(matrix.channels()),
            .pixels = {matrix.data, matrix.total() * matrix.elemSize()}};
}

/// The bytes of a PNG file, made by libpng: OpenCV's own writer would pull a geographic library and 50 MB of memory
/// into every command. Throws Error.
std::string png_bytes(const PixelView& image);

/// Writes them; beside and renamed. Throws Error naming the file.
void write_png(const std::filesystem::path& path, const PixelView& image);

/// Reads an 8-bit grey PNG of that size: its pixels row by row from the top. The size is asked for, so that a damaged
/// header cannot ask for all memory. Throws Error naming the file and what it holds instead.
std::vector<std::uint8_t> read_grey_png(const std::filesystem::path& path, std::size_t width_px, std::size_t height_px);

}  // namespace ddtool

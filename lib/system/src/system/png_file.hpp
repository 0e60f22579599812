#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace ddtool {

/// 8-bit pixels, row by row from the top, without padding. One channel is grey, three are BGR (OpenCV's order).
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

/// Returns the bytes of a PNG file. Uses libpng, because OpenCV's writer would load a geographic library, and with it
/// 50 MB of memory, into every command. Throws Error if the image cannot be encoded.
std::string png_bytes(const PixelView& image);

/// Writes a PNG file through AtomicFile. Throws Error naming the file.
void write_png(const std::filesystem::path& path, const PixelView& image);

/// Reads an 8-bit grey PNG of the given size and returns its pixels row by row from the top. The size has to be given
/// so that a damaged header cannot claim all memory. Throws Error naming the file and what it contains instead.
std::vector<std::uint8_t> read_grey_png(const std::filesystem::path& path, std::size_t width_px, std::size_t height_px);

/// A picture as it is stored in a file, brought to 8 bits: row by row from the top.
struct GreyPicture {
    std::size_t width_px = 0;
    std::size_t height_px = 0;
    std::vector<std::uint8_t> grey;     ///< the mean of red, green and blue
    std::vector<std::uint8_t> opacity;  ///< 255 where nothing is transparent; empty if nothing is anywhere
};

/// Reads a PNG file of any kind. Throws Error naming the file if it is no PNG, damaged, or has more pixels than
/// `most_pixels`.
GreyPicture read_png(const std::filesystem::path& path, std::size_t most_pixels);

}  // namespace ddtool

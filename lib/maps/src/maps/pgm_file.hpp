#pragma once

#include <cstddef>
#include <filesystem>

#include "system/png_file.hpp"

namespace ddtool::maps {

/// Reads a PGM file (Netpbm's P5 or P2, with comments), its greys brought to 0..255. Throws Error naming the file if it
/// is none, ends too early, or has more pixels than `most_pixels`.
GreyPicture read_pgm(const std::filesystem::path& file, std::size_t most_pixels);

}  // namespace ddtool::maps

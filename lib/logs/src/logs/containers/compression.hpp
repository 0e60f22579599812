#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace ddtool {

/// How the records of a chunk, or a message, are compressed: lz4 in its frame format, zstd, bzip2, or not at all.
enum class Compression { none, lz4, zstd, bzip2 };

/// The same bytes for the same input and library version.
std::vector<std::byte> compress(Compression compression, std::span<const std::byte> records);

/// What came out of decompress().
struct Decompressed {
    std::span<const std::byte> records;  ///< a view of the buffer, or of the input where nothing was compressed
    std::string failure;                 ///< empty when `records` is all that was expected
};

/// Undoes compress(). `expected_size` bounds the output; the buffer (reused, never shrunk) grows only as data really
/// comes, so that a few bytes cannot claim gigabytes. On a failure `records` holds what was decoded before it, which
/// for an input that was cut off is right as far as it goes.
Decompressed decompress(Compression compression, std::span<const std::byte> compressed, std::uint64_t expected_size,
                        std::vector<std::byte>& buffer);

}  // namespace ddtool

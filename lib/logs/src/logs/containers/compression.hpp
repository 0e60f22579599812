#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace ddtool {

/// How the records of a chunk, or a message, are compressed: with lz4 in its frame format, zstd, bzip2, or not at all.
enum class Compression { none, lz4, zstd, bzip2 };

/// Compresses the records. The same input gives the same bytes, with the same version of the compression library.
std::vector<std::byte> compress(Compression compression, std::span<const std::byte> records);

/// What came out of decompress().
struct Decompressed {
    std::span<const std::byte> records;  ///< in the buffer, or in the input if it was not compressed
    std::string failure;                 ///< empty if `records` is all that was expected
};

/// Undoes compress(). On a failure, `records` holds what was decoded before it; for an input that was cut off this is
/// correct as far as it goes.
/// \param expected_size the largest size of the output, in bytes
/// \param buffer holds the output; it is reused, and grows only as data are really decoded, so that a few damaged bytes
///     cannot claim gigabytes
Decompressed decompress(Compression compression, std::span<const std::byte> compressed, std::uint64_t expected_size,
                        std::vector<std::byte>& buffer);

}  // namespace ddtool

#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace ddtool {

/// How the records of a chunk are compressed: lz4 in its frame format, zstd, or not at all.
enum class McapCompression { none, lz4, zstd };

/// The name in the chunk's compression field ("" for none).
std::string_view mcap_compression_name(McapCompression compression);
/// None for a name that the specification does not know.
std::optional<McapCompression> mcap_compression_of(std::string_view name);

/// The records of a chunk. The same bytes for the same input and library version.
std::vector<std::byte> compress(McapCompression compression, std::span<const std::byte> records);

/// What came out of decompress().
struct Decompressed {
    std::span<const std::byte> records;  ///< a view of the buffer, or of the input where nothing was compressed
    std::string failure;                 ///< empty when `records` is all that was expected
};

/// Undoes compress(). `expected_size` bounds the output; the buffer (reused, never shrunk) grows only as data really
/// comes, so that a few bytes cannot claim gigabytes. On a failure `records` holds what was decoded before it, which
/// for an input that was cut off is right as far as it goes.
Decompressed decompress(McapCompression compression, std::span<const std::byte> compressed, std::uint64_t expected_size,
                        std::vector<std::byte>& buffer);

}  // namespace ddtool

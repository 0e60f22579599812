#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace ddtool {

/// How a file, the records of a chunk, or a message, are compressed: with lz4 in its frame format, zstd, bzip2, gzip
/// (files only), or not at all.
enum class Compression { none, lz4, zstd, bzip2, gzip };

/// Recognises compressed data by their first bytes (four are enough).
Compression compression_of_start(std::span<const std::byte> start);

/// "lz4", "zstd", "bzip2", "gzip"; empty for none.
std::string_view name_of(Compression compression);

/// Undoes one frame (zstd, lz4), stream (bzip2) or member (gzip) of compressed data, step by step. For one thread at a
/// time.
class Decoder {
public:
    struct Step {
        std::size_t taken = 0;  ///< bytes of the input that were used
        std::size_t given = 0;  ///< bytes of the output that were written
        bool ended = false;     ///< the frame is complete
        std::string error;      ///< empty: none
    };

    Decoder() = default;
    virtual ~Decoder() = default;
    Decoder(const Decoder&) = delete;
    Decoder& operator=(const Decoder&) = delete;

    /// Decodes as much as the input gives and the output holds. After an error or the end it must not be called again.
    virtual Step step(std::span<const std::byte> in, std::span<std::byte> out) = 0;
};

/// Throws Error for Compression::none, and if there is no memory.
std::unique_ptr<Decoder> make_decoder(Compression compression);

/// Compresses the records, but not with gzip. The same input gives the same bytes, with the same version of the
/// compression library.
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

#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "logs/containers/byte_source.hpp"

namespace ddtool {

/// The part of a chunk that could be read.
struct McapChunk {
    std::span<const std::byte> records;  ///< valid until the next chunk is read
    bool cut_off = false;                ///< the file ends within the chunk; `records` may end within a record
    std::string problem;                 ///< what is wrong with the chunk; empty if it is intact
    std::uint64_t bytes_lost = 0;
};

/// Reads, decompresses and checks chunks, one held at a time.
class McapChunkReader {
public:
    /// Reads the content of a Chunk record from its start to its end. A chunk that fails its CRC or cannot be
    /// decompressed gives no records.
    /// \param length the length of the content in bytes
    McapChunk read(ByteSource& source, std::uint64_t length);

private:
    [[nodiscard]] McapChunk unpack(bool cut_off);

    std::vector<std::byte> stored_;
    std::vector<std::byte> decompressed_;
};

}  // namespace ddtool

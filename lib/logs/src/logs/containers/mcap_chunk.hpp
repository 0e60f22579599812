#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "logs/containers/byte_source.hpp"

namespace ddtool {

/// What could be read of a chunk.
struct McapChunk {
    std::span<const std::byte> records;  ///< valid until the next chunk is read
    bool cut_off = false;                ///< the file ends within the chunk; `records` may end within a record
    std::string problem;                 ///< what is wrong with it; empty when nothing is
    std::uint64_t bytes_lost = 0;
};

/// Reads, decompresses and checks chunks, one held at a time.
class McapChunkReader {
public:
    /// From the start of a Chunk record's content to its end. A chunk that fails its CRC or does not decompress gives
    /// no records.
    McapChunk read(ByteSource& source, std::uint64_t length);

private:
    [[nodiscard]] McapChunk unpack(bool cut_off);

    std::vector<std::byte> stored_;
    std::vector<std::byte> decompressed_;
};

}  // namespace ddtool

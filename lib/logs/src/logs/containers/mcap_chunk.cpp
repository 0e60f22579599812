#include "logs/containers/mcap_chunk.hpp"

#include <algorithm>
#include <utility>

#include "ddtool/base/error.hpp"
#include "logs/containers/mcap_compression.hpp"
#include "logs/containers/mcap_fields.hpp"
#include "system/crc.hpp"

namespace ddtool {
namespace {

Compression take_compression(McapFieldReader& fields) {
    const std::string name = fields.take_string();
    const auto compression = mcap_compression_of(name);
    if (!compression) {
        throw Error("compression '" + name + "' where '', 'lz4' or 'zstd' was expected");
    }
    return *compression;
}

/// Takes the compressed records. In a chunk that is cut off there are fewer bytes than it declares.
std::span<const std::byte> take_records(McapFieldReader& fields, bool cut_off) {
    const auto size = fields.take<std::uint64_t>();
    return fields.take_bytes(cut_off ? std::min<std::uint64_t>(size, fields.rest().size()) : size);
}

}  // namespace

McapChunk McapChunkReader::read(ByteSource& source, std::uint64_t length) {
    stored_.clear();
    const std::uint64_t missing = length - source.append_to(stored_, length);
    try {
        McapChunk chunk = unpack(missing > 0);
        if (chunk.cut_off) {
            chunk.problem = "chunk is cut off: " + std::to_string(missing) + " of its " + std::to_string(length) +
                            " bytes are missing";
            chunk.bytes_lost = missing;
        }
        return chunk;
    } catch (const Error& error) {
        return {{}, missing > 0, std::string("chunk is skipped: ") + error.what(), length};
    }
}

McapChunk McapChunkReader::unpack(bool cut_off) {
    McapFieldReader fields(stored_);
    fields.take_bytes(2 * sizeof(std::uint64_t));  // earliest and latest log time
    const auto uncompressed_size = fields.take<std::uint64_t>();
    const auto crc = fields.take<std::uint32_t>();
    const Compression compression = take_compression(fields);
    if (uncompressed_size > mcap_max_held_bytes) {
        throw Error("it declares " + std::to_string(uncompressed_size) + " bytes of records, more than the limit of " +
                    std::to_string(mcap_max_held_bytes));
    }
    const auto [records, failure] =
        decompress(compression, take_records(fields, cut_off), uncompressed_size, decompressed_);
    if (!failure.empty() && !cut_off) {
        throw Error(failure);
    }
    if (failure.empty() && crc != 0 && crc != crc32_of(records)) {
        throw Error("its records do not match their CRC");
    }
    return {records, cut_off, "", 0};
}

}  // namespace ddtool

#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include "logs/mcap_compression.hpp"

namespace ddtool {

struct McapWriterOptions {
    std::string profile;  ///< MCAP Format Registry; "ros2" when every channel is ROS 2
    McapCompression compression = McapCompression::zstd;
    std::size_t chunk_bytes = std::size_t{1} << 20;  ///< before compression; a chunk is written when it reaches this
};

/// Writes an MCAP file (https://mcap.dev/spec): chunks with message indexes, a summary with statistics and chunk
/// indexes, every CRC. The file appears under its name at close(); without it, nothing is left behind.
/// The same calls give the same bytes.
class McapWriter {
public:
    /// Throws Error when the file cannot be created; as do all others when it cannot be written.
    explicit McapWriter(const std::filesystem::path& path, McapWriterOptions options = {});
    ~McapWriter();
    McapWriter(const McapWriter&) = delete;
    McapWriter& operator=(const McapWriter&) = delete;

    /// Returns the channel's id. Channels with the same schema share one record of it; an empty schema_name means none.
    std::uint16_t add_channel(std::string_view topic, std::string_view message_encoding, std::string_view schema_name,
                              std::string_view schema_encoding, std::string_view schema_data);
    /// The publish time is the log time; the sequence number counts the channel's messages.
    void write(std::uint16_t channel, std::int64_t log_time_ns, std::span<const std::byte> data);
    void close();
};

}  // namespace ddtool

#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "logs/containers/compression.hpp"
#include "logs/containers/mcap_chunk_builder.hpp"
#include "logs/containers/mcap_fields.hpp"
#include "logs/containers/mcap_output.hpp"

namespace ddtool {

struct McapWriterOptions {
    std::string profile;  ///< MCAP Format Registry; "ros2" when every channel is ROS 2
    Compression compression = Compression::zstd;
    std::size_t chunk_bytes = std::size_t{1} << 20;  ///< before compression; a chunk is written when it reaches this
};

/// Writes an MCAP file (https://mcap.dev/spec): chunks with message indexes, a summary with statistics and chunk
/// indexes, and every CRC. The file appears under its name at close(); without close() no file is left behind. The same
/// calls give the same bytes. Every call throws OutputError naming the file if it cannot be written. For one thread at
/// a time.
class McapWriter {
public:
    explicit McapWriter(const std::filesystem::path& path, McapWriterOptions options = {});

    /// Adds a channel and returns its id. Channels with the same schema share one Schema record. An empty schema_name
    /// means that the channel has no schema.
    std::uint16_t add_channel(std::string_view topic, std::string_view message_encoding, std::string_view schema_name,
                              std::string_view schema_encoding, std::string_view schema_data,
                              const std::map<std::string, std::string>& metadata = {});
    /// Writes a message. Its publish time is the log time, and its sequence number counts the messages of the channel
    /// from 0.
    /// \param channel an id that add_channel() returned
    void write(std::uint16_t channel, std::int64_t log_time_ns, std::span<const std::byte> data);
    void close();

private:
    std::uint16_t add_schema(std::string_view name, std::string_view encoding, std::string_view data);
    void write_chunk();
    void write_summary();
    [[nodiscard]] McapFieldWriter statistics() const;

    McapOutput output_;
    McapWriterOptions options_;
    McapChunkBuilder chunk_;
    std::map<std::string, std::uint16_t> schema_ids_;  ///< by the schema's fields, as they are written
    std::vector<std::uint32_t> message_counts_;        ///< by channel id, from 1
    McapTimeSpan times_;
    std::uint32_t chunk_count_ = 0;
    McapFieldWriter schemas_;  ///< records for the summary, as in the next two
    McapFieldWriter channels_;
    McapFieldWriter chunk_indexes_;
};

}  // namespace ddtool

#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <set>
#include <span>

#include "ddtool/logs/log_problem.hpp"
#include "logs/containers/byte_source.hpp"
#include "logs/containers/mcap_data_section.hpp"
#include "logs/containers/mcap_definitions.hpp"
#include "logs/containers/mcap_format.hpp"
#include "logs/containers/mcap_types.hpp"

namespace ddtool {

/// Reads the messages of an MCAP file (https://mcap.dev/spec) in the order of the file, forward only, with one chunk in
/// memory at a time. Files may be chunked or not, compressed with lz4 or zstd, with or without index and summary; every
/// CRC that exists is checked. Damage is reported to the handler, and reading continues where the next record is known
/// to begin: a damaged chunk is skipped, and of a chunk that is cut off the messages before the cut are read. For one
/// thread at a time.
class McapReader {
public:
    /// Throws Error if the source cannot be read or is not an MCAP file; the message says what it looks like.
    McapReader(ByteSource source, LogProblemHandler on_problem);
    McapReader(const std::filesystem::path& path, LogProblemHandler on_problem);

    /// The next message; nullopt at the end. Its data are valid until the next call.
    std::optional<McapMessage> next();
    /// Share of the file read, 0..1; 0 where its length is unknown (a pipe).
    [[nodiscard]] double fraction_read() const { return section_.fraction_read(); }

private:
    std::optional<McapMessage> interpret(McapOpcode opcode, std::span<const std::byte> content);
    std::optional<McapMessage> message_of(std::span<const std::byte> content);

    McapDataSection section_;
    LogRecordWalk<McapDataSection> records_;
    McapDefinitions definitions_;
    std::set<std::uint16_t> undefined_channels_;
};

}  // namespace ddtool

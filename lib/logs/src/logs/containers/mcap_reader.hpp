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

/// Reads the messages of an MCAP file (https://mcap.dev/spec) in the file's order, forward only, holding one chunk at a
/// time. Chunked or not, lz4 or zstd, with or without index and summary; every CRC that is there is checked.
/// Damage goes to the handler and reading continues where the next record is known to start: a damaged chunk is
/// skipped, a chunk that is cut off gives the messages before the cut.
class McapReader {
public:
    /// Throws Error when the source cannot be read or is not an MCAP file, saying what it looks like.
    McapReader(ByteSource source, LogProblemHandler on_problem);
    McapReader(const std::filesystem::path& path, LogProblemHandler on_problem);

    /// The next message; none at the end.
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

#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <span>
#include <vector>

#include "logs/containers/compression.hpp"
#include "logs/containers/mcap_fields.hpp"
#include "logs/containers/mcap_output.hpp"

namespace ddtool {

/// The earliest and latest log time of some messages; both 0 when there are none.
class McapTimeSpan {
public:
    void add(std::uint64_t log_time_ns) {
        first_ = std::min(first_, log_time_ns);
        last_ = std::max(last_, log_time_ns);
    }
    [[nodiscard]] std::uint64_t first() const { return std::min(first_, last_); }
    [[nodiscard]] std::uint64_t last() const { return last_; }

private:
    std::uint64_t first_ = std::numeric_limits<std::uint64_t>::max();
    std::uint64_t last_ = 0;
};

/// Collects messages until they are written as one chunk with its message indexes.
class McapChunkBuilder {
public:
    void add(std::uint16_t channel, std::uint32_t sequence, std::uint64_t log_time_ns, std::span<const std::byte> data);
    /// The size of the records in bytes, before compression.
    [[nodiscard]] std::size_t size() const { return records_.size(); }
    /// Writes the chunk, appends its Chunk Index record to `chunk_indexes`, and is empty again.
    void write(McapOutput& output, Compression compression, McapFieldWriter& chunk_indexes);

private:
    struct Indexed {
        std::uint64_t log_time_ns = 0;
        std::uint64_t offset = 0;  ///< in the chunk's records
    };

    McapFieldWriter records_;
    McapTimeSpan times_;
    std::map<std::uint16_t, std::vector<Indexed>> messages_;  ///< by channel
};

}  // namespace ddtool

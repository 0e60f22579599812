#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>

#include "logs/containers/mcap_fields.hpp"
#include "system/atomic_file.hpp"

namespace ddtool {

/// A file that is being written, with its length and the CRC-32 of the section being written. It appears under its name
/// at commit(). Every call throws OutputError naming the file if it cannot be written.
class McapOutput {
public:
    explicit McapOutput(const std::filesystem::path& path) : file_(path) {}

    void put(std::span<const std::byte> bytes);
    void put_record(McapOpcode opcode, const McapFieldWriter& content);
    void commit() { file_.close(); }

    /// Bytes written so far.
    [[nodiscard]] std::uint64_t offset() const { return offset_; }
    /// The CRC-32 of what was written since the start or since restart_crc().
    [[nodiscard]] std::uint32_t crc() const { return crc_; }
    void restart_crc() { crc_ = 0; }

private:
    AtomicStream file_;
    std::uint64_t offset_ = 0;
    std::uint32_t crc_ = 0;
};

}  // namespace ddtool

#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <istream>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "logs/containers/live_buffer.hpp"

namespace ddtool {

/// Bytes read strictly forward, from a file or a pipe, with their running CRC-32.
class ByteSource {
public:
    /// Opens a file. Throws Error naming it and the system's reason.
    explicit ByteSource(const std::filesystem::path& path);
    /// Any stream; its length is unknown.
    ByteSource(std::unique_ptr<std::istream> stream, std::string name);
    /// Bytes that come while they are read; their length is unknown.
    ByteSource(std::unique_ptr<LiveBuffer> live, std::string name);

    /// Fills `into`; returns how many bytes came, fewer only at the end. Throws Error when the system cannot read.
    std::size_t read(std::span<std::byte> into);
    /// Appends the next `size` bytes, or fewer at the end; returns how many. Memory grows with what really comes, not
    /// with `size`.
    std::uint64_t append_to(std::vector<std::byte>& into, std::uint64_t size);
    /// Reads over `size` bytes; returns how many there were.
    std::uint64_t skip(std::uint64_t size);
    static constexpr std::uint64_t everything = std::numeric_limits<std::uint64_t>::max();
    /// The content ends here: of a file that is followed, nothing more is waited for.
    void wait_no_more();

    [[nodiscard]] const std::string& name() const { return name_; }
    /// Bytes read so far.
    [[nodiscard]] std::uint64_t offset() const { return offset_; }
    /// Bytes left; none where the length is unknown.
    [[nodiscard]] std::optional<std::uint64_t> remaining() const;
    /// Share read, 0..1; 0 where the length is unknown.
    [[nodiscard]] double fraction_read() const;

    /// CRC-32 (as zlib's) of what was read since the start or the last restart.
    [[nodiscard]] std::uint32_t crc() const { return crc_; }
    void restart_crc() { crc_ = 0; }

private:
    std::unique_ptr<LiveBuffer> live_;  ///< behind the stream, where there is one
    std::unique_ptr<std::istream> stream_;
    std::string name_;
    std::optional<std::uint64_t> size_;
    std::uint64_t offset_ = 0;
    std::uint32_t crc_ = 0;
};

}  // namespace ddtool

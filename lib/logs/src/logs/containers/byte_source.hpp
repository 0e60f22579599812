#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <istream>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <streambuf>
#include <string>
#include <vector>

#include "logs/containers/live_buffer.hpp"

namespace ddtool {

/// Bytes that are made of those of another source, such as its decompressed content.
class LayerBuffer : public std::streambuf {
public:
    /// The share of the other source that has been read, 0..1.
    [[nodiscard]] virtual double fraction_read() const = 0;
};

/// Bytes that are read strictly forward, from a file or a pipe, with a running CRC-32. For one thread at a time.
class ByteSource {
public:
    /// Opens a file. Throws Error naming it and the system's reason.
    explicit ByteSource(const std::filesystem::path& path);
    /// Reads from any stream, whose length is then unknown. `name` stands for it in messages.
    ByteSource(std::unique_ptr<std::istream> stream, std::string name);
    /// Reads bytes that are still being produced; their length is unknown. `name` stands for them in messages.
    ByteSource(std::unique_ptr<LiveBuffer> live, std::string name);
    /// Reads what a layer makes of another source. `name` stands for it in messages.
    ByteSource(std::unique_ptr<LayerBuffer> layer, std::string name);

    /// The first `size` bytes, or all if there are fewer, which are not taken; only before anything has been read.
    std::span<const std::byte> start(std::size_t size);
    /// Fills `into` and returns the number of bytes read, which is smaller than the size of `into` only at the end.
    /// Throws Error if the system cannot read.
    std::size_t read(std::span<std::byte> into);
    /// Appends the next `size` bytes, or fewer at the end, and returns their number. Memory grows with the bytes that
    /// are really there, so that a damaged `size` does no harm.
    std::uint64_t append_to(std::vector<std::byte>& into, std::uint64_t size);
    /// Skips `size` bytes and returns how many there were.
    std::uint64_t skip(std::uint64_t size);
    static constexpr std::uint64_t everything = std::numeric_limits<std::uint64_t>::max();
    /// Declares that the content ends here: if the file is being followed, no more bytes are waited for.
    void wait_no_more();

    [[nodiscard]] const std::string& name() const { return name_; }
    /// Bytes read so far.
    [[nodiscard]] std::uint64_t offset() const { return offset_; }
    /// The number of bytes left; nullopt if the length is unknown.
    [[nodiscard]] std::optional<std::uint64_t> remaining() const;
    /// The share that has been read, 0..1; 0 if it is unknown.
    [[nodiscard]] double fraction_read() const;

    /// CRC-32 (as zlib's) of what was read since the start or the last restart.
    [[nodiscard]] std::uint32_t crc() const { return crc_; }
    void restart_crc() { crc_ = 0; }

private:
    std::size_t read_stream(std::span<std::byte> into);

    std::unique_ptr<LiveBuffer> live_;    ///< behind the stream, where there is one
    std::unique_ptr<LayerBuffer> layer_;  ///< likewise
    std::unique_ptr<std::istream> stream_;
    std::string name_;
    std::vector<std::byte> start_;  ///< read from the stream, but not yet taken
    std::optional<std::uint64_t> size_;
    std::uint64_t offset_ = 0;
    std::uint32_t crc_ = 0;
};

}  // namespace ddtool

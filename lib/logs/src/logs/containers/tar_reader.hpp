#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "logs/containers/byte_source.hpp"

namespace ddtool {

/// Whether a file that begins with these bytes (512 are enough) is a tar archive: its first header has the checksum
/// that it states.
bool is_tar(std::span<const std::byte> start);

/// The regular files of a tar archive (POSIX.1-2001 pax, ustar, GNU and older), read strictly forward. What is damaged
/// ends the archive. For one thread at a time.
class TarReader {
public:
    struct Entry {
        std::string name;
        std::uint64_t bytes = 0;
    };

    explicit TarReader(ByteSource source) : source_(std::move(source)) {}

    /// Goes on to the next regular file; nullopt at the end.
    std::optional<Entry> next();
    /// Reads on in that file. Returns the number of bytes, which is smaller than the size of `into` only at its end, or
    /// where the archive is cut off.
    std::size_t read(std::span<std::byte> into);
    /// Whether the archive ended within the file that was read last.
    [[nodiscard]] bool is_cut_off() const { return cut_off_; }
    [[nodiscard]] double fraction_read() const { return source_.fraction_read(); }

private:
    std::string take_text(std::uint64_t size);
    void take_pax(const std::string& records);

    ByteSource source_;
    std::uint64_t left_ = 0;     ///< bytes of the current file
    std::uint64_t padding_ = 0;  ///< bytes after it
    std::string long_name_;      ///< of the next file, where its header has no room for it
    std::optional<std::uint64_t> long_size_;
    bool cut_off_ = false;
};

}  // namespace ddtool

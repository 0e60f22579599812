#pragma once

#include <cstddef>
#include <filesystem>
#include <span>

namespace ddtool {

/// A file seen as memory, read only; the system loads what is touched and drops it when memory is short. The bytes are
/// aligned to a page.
class MappedFile {
public:
    /// Throws Error naming the file and the system's reason.
    explicit MappedFile(const std::filesystem::path& path);
    ~MappedFile();
    MappedFile(MappedFile&& other) noexcept;
    MappedFile& operator=(MappedFile&& other) noexcept;
    MappedFile(const MappedFile&) = delete;
    MappedFile& operator=(const MappedFile&) = delete;

    /// Valid as long as this or what it was moved into lives. A file that is cut short while it is mapped ends the
    /// program (SIGBUS): files here are replaced by renaming, never rewritten.
    [[nodiscard]] std::span<const std::byte> bytes() const { return bytes_; }

private:
    std::span<const std::byte> bytes_;
};

}  // namespace ddtool

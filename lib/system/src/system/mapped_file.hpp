#pragma once

#include <cstddef>
#include <filesystem>
#include <span>

namespace ddtool {

/// A file mapped into memory, read only. The system loads the pages that are used and drops them when memory is short.
/// The bytes are aligned to a page.
class MappedFile {
public:
    /// Throws Error naming the file and the system's reason.
    explicit MappedFile(const std::filesystem::path& path);
    ~MappedFile();
    MappedFile(MappedFile&& other) noexcept;
    MappedFile& operator=(MappedFile&& other) noexcept;
    MappedFile(const MappedFile&) = delete;
    MappedFile& operator=(const MappedFile&) = delete;

    /// Valid as long as this object, or the one that it was moved into, exists. If the file is shortened while it is
    /// mapped, the program is ended by SIGBUS; therefore ddtool replaces files by renaming and never rewrites them in
    /// place.
    [[nodiscard]] std::span<const std::byte> bytes() const { return bytes_; }

private:
    std::span<const std::byte> bytes_;
};

}  // namespace ddtool

#pragma once

#include <filesystem>

#include "logs/containers/byte_source.hpp"

namespace ddtool {

/// The content of a source as a file of its own, for libraries that read only files, in the folder that TMPDIR names,
/// or /tmp. It is removed with this object; whoever opens the file may call remove() before, so that nothing stays
/// behind even if the program is killed.
class TemporaryCopy {
public:
    /// Reads the source to its end. Throws Error naming the folder and the system's reason if it cannot be written.
    explicit TemporaryCopy(ByteSource source);
    ~TemporaryCopy() { remove(); }
    TemporaryCopy(const TemporaryCopy&) = delete;
    TemporaryCopy& operator=(const TemporaryCopy&) = delete;

    [[nodiscard]] const std::filesystem::path& path() const { return path_; }
    /// Removes the name of the file. Its content lives as long as somebody has it open.
    void remove();

private:
    std::filesystem::path path_;
};

}  // namespace ddtool

#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <span>

#include "ddtool/logs/log_problem.hpp"

namespace ddtool {

/// The content of a text file, decompressed while it is read.
class TextSource {
public:
    TextSource() = default;
    virtual ~TextSource() = default;
    TextSource(const TextSource&) = delete;
    TextSource& operator=(const TextSource&) = delete;

    /// Fills the buffer and returns the number of bytes, which is smaller than the size of the buffer only at the end.
    virtual std::size_t read(std::span<char> buffer) = 0;
    /// Share of the file already read, 0..1.
    [[nodiscard]] virtual double fraction_read() const = 0;
};

/// Opens a plain, gzip or bzip2 file, recognised by its first bytes. Throws Error if it cannot be opened. Damage that
/// is found later is reported to the handler, and ends the content.
std::unique_ptr<TextSource> open_text(const std::filesystem::path& path, LogProblemHandler on_problem);

}  // namespace ddtool

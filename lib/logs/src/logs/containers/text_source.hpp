#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <span>

#include "ddtool/logs/log_problem.hpp"

namespace ddtool {

/// The content of a text file, decompressed on the way.
class TextSource {
public:
    TextSource() = default;
    virtual ~TextSource() = default;
    TextSource(const TextSource&) = delete;
    TextSource& operator=(const TextSource&) = delete;

    /// Fills the buffer as far as the content goes; fewer bytes than asked for only at its end.
    virtual std::size_t read(std::span<char> buffer) = 0;
    /// Share of the file already read, 0..1.
    [[nodiscard]] virtual double fraction_read() const = 0;
};

/// Opens a plain, gzip or bzip2 file, told apart by their first bytes. Throws Error when it cannot be opened; damage
/// found later ends the content and is told to the handler.
std::unique_ptr<TextSource> open_text(const std::filesystem::path& path, LogProblemHandler on_problem);

}  // namespace ddtool

#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "logs/containers/byte_source.hpp"

namespace ddtool {

/// The lines of a text, in bounded memory: a line that is longer than max_line_bytes is cut at that length.
class LineReader {
public:
    static constexpr std::size_t max_line_bytes = 1 << 20;

    explicit LineReader(ByteSource source);

    /// The next line without its newline; nullopt at the end. Valid until the next call.
    std::optional<std::string_view> next();
    /// The number of the line that next() returned last, counted from 1.
    [[nodiscard]] std::size_t line_number() const { return line_number_; }
    [[nodiscard]] double fraction_read() const { return source_.fraction_read(); }

private:
    bool refill();

    ByteSource source_;
    std::string buffer_;
    std::string_view unread_;
    std::string line_;
    std::size_t line_number_ = 0;
};

}  // namespace ddtool

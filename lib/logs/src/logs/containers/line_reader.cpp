#include "logs/containers/line_reader.hpp"

#include <algorithm>
#include <utility>

namespace ddtool {
namespace {

constexpr std::size_t line_buffer_bytes = 1 << 16;

}  // namespace

LineReader::LineReader(ByteSource source) : source_(std::move(source)), buffer_(line_buffer_bytes, '\0') {}

bool LineReader::refill() {
    unread_ = std::string_view(buffer_).substr(0, source_.read(std::as_writable_bytes(std::span(buffer_))));
    return !unread_.empty();
}

std::optional<std::string_view> LineReader::next() {
    line_.clear();
    if (unread_.empty() && !refill()) {
        return std::nullopt;
    }
    ++line_number_;
    do {
        const std::size_t end = std::min(unread_.find('\n'), unread_.size());
        line_.append(unread_.substr(0, std::min(end, max_line_bytes - line_.size())));
        const bool complete = end < unread_.size();
        unread_.remove_prefix(complete ? end + 1 : end);
        if (complete) {
            break;
        }
    } while (refill());
    return line_;
}

}  // namespace ddtool

#include "logs/containers/mcap_fields.hpp"

#include <limits>

#include "ddtool/base/error.hpp"

namespace ddtool {

std::span<const std::byte> McapFieldReader::take_bytes(std::uint64_t count) {
    if (count > rest_.size()) {
        throw Error("a field of " + std::to_string(count) + " bytes where only " + std::to_string(rest_.size()) +
                    " are left");
    }
    const auto taken = rest_.first(static_cast<std::size_t>(count));
    rest_ = rest_.subspan(taken.size());
    return taken;
}

std::string McapFieldReader::take_string() {
    const auto text = take_bytes(take<std::uint32_t>());
    return {reinterpret_cast<const char*>(text.data()), text.size()};
}

std::map<std::string, std::string> McapFieldReader::take_string_map() {
    McapFieldReader entries(take_bytes(take<std::uint32_t>()));
    std::map<std::string, std::string> map;
    while (!entries.rest().empty()) {
        std::string key = entries.take_string();
        map[std::move(key)] = entries.take_string();
    }
    return map;
}

McapFieldWriter& McapFieldWriter::put_bytes(std::span<const std::byte> bytes) {
    bytes_.insert(bytes_.end(), bytes.begin(), bytes.end());
    return *this;
}

McapFieldWriter& McapFieldWriter::put_array(std::span<const std::byte> content) {
    if (content.size() > std::numeric_limits<std::uint32_t>::max()) {
        throw Error("MCAP: a field of " + std::to_string(content.size()) + " bytes where at most 2^32 - 1 fit");
    }
    return put(static_cast<std::uint32_t>(content.size())).put_bytes(content);
}

McapFieldWriter& McapFieldWriter::put_string(std::string_view text) {
    return put_array(std::as_bytes(std::span(text)));
}

McapFieldWriter& McapFieldWriter::put_record_header(McapOpcode opcode, std::uint64_t content_bytes) {
    return put(static_cast<std::uint8_t>(opcode)).put(content_bytes);
}

McapFieldWriter& McapFieldWriter::put_record(McapOpcode opcode, const McapFieldWriter& content) {
    return put_record_header(opcode, content.size()).put_bytes(content.bytes());
}

}  // namespace ddtool

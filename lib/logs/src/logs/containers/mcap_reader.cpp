#include "logs/containers/mcap_reader.hpp"

#include <string>
#include <utility>

#include "ddtool/base/error.hpp"
#include "logs/containers/mcap_fields.hpp"

namespace ddtool {
namespace {

struct McapRecord {
    McapOpcode opcode;
    std::span<const std::byte> content;
};

McapRecord take_mcap_record(McapFieldReader& fields) {
    const McapOpcode opcode{fields.take<std::uint8_t>()};
    return {opcode, fields.take_bytes(fields.take<std::uint64_t>())};
}

}  // namespace

McapReader::McapReader(ByteSource source, LogProblemHandler on_problem)
    : section_(std::move(source), std::move(on_problem)) {}

McapReader::McapReader(const std::filesystem::path& path, LogProblemHandler on_problem)
    : McapReader(ByteSource(path), std::move(on_problem)) {}

std::optional<McapMessage> McapReader::next() {
    return records_.next(section_, take_mcap_record,
                         [this](const McapRecord& record) { return interpret(record.opcode, record.content); });
}

std::optional<McapMessage> McapReader::interpret(McapOpcode opcode, std::span<const std::byte> content) {
    switch (opcode) {
        case McapOpcode::schema:
            definitions_.add_schema(content);
            break;
        case McapOpcode::channel:
            definitions_.add_channel(content);
            break;
        case McapOpcode::message:
            return message_of(content);
        default:  // record types that later versions of the specification add, and private ones
            break;
    }
    return std::nullopt;
}

std::optional<McapMessage> McapReader::message_of(std::span<const std::byte> content) {
    McapFieldReader fields(content);
    const auto channel_id = fields.take<std::uint16_t>();
    McapMessage message;
    message.channel = definitions_.find_channel(channel_id);
    message.sequence = fields.take<std::uint32_t>();
    message.log_time_ns = static_cast<std::int64_t>(fields.take<std::uint64_t>());
    message.publish_time_ns = static_cast<std::int64_t>(fields.take<std::uint64_t>());
    message.data = fields.rest();
    message.file_offset = records_.offset();
    if (message.channel != nullptr) {
        return message;
    }
    if (undefined_channels_.insert(channel_id).second) {
        throw Error("channel " + std::to_string(channel_id) +
                    " is not defined before this message; its other messages are skipped too");
    }
    return std::nullopt;
}

}  // namespace ddtool

#include "logs/mcap_reader.hpp"

#include <string>
#include <utility>

#include "base/error.hpp"
#include "logs/mcap_fields.hpp"

namespace ddtool {

McapReader::McapReader(ByteSource source, LogProblemHandler on_problem)
    : section_(std::move(source), std::move(on_problem)) {}

McapReader::McapReader(const std::filesystem::path& path, LogProblemHandler on_problem)
    : McapReader(ByteSource(path), std::move(on_problem)) {}

std::optional<McapMessage> McapReader::next() {
    for (;;) {
        while (!records_.bytes.empty()) {
            if (auto message = take_record()) {
                return message;
            }
        }
        const auto records = section_.next();
        if (!records) {
            return std::nullopt;
        }
        records_ = *records;
    }
}

std::optional<McapMessage> McapReader::take_record() {
    // Nothing is left unless the record is seen to end: one that does not loses all after it.
    const auto before = std::exchange(records_.bytes, {});
    try {
        McapFieldReader fields(before);
        const auto opcode = fields.take<std::uint8_t>();
        const auto content = fields.take_bytes(fields.take<std::uint64_t>());
        records_.bytes = fields.rest();
        return interpret(McapOpcode{opcode}, content);
    } catch (const Error& error) {
        if (!records_.cut_off || !records_.bytes.empty()) {
            section_.report(records_.offset, std::string("record is skipped: ") + error.what(),
                            before.size() - records_.bytes.size());
        }
        return std::nullopt;
    }
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
        default:  // what the specification may add, and private records
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
    message.file_offset = records_.offset;
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

#include "logs/containers/bag_reader.hpp"

#include <string>
#include <utility>
#include <vector>

#include "ddtool/base/error.hpp"
#include "logs/containers/mcap_fields.hpp"

namespace ddtool {
namespace {

/// Limit on the memory for the index of a bag. What lies beyond it is not read.
constexpr std::uint64_t max_index_bytes = std::uint64_t{64} << 20;

struct BagRecord {
    std::span<const std::byte> header;
    std::span<const std::byte> data;
};

BagRecord take_bag_record(McapFieldReader& fields) {
    const auto header = fields.take_bytes(fields.take<std::uint32_t>());
    return {header, fields.take_bytes(fields.take<std::uint32_t>())};
}

/// The topic is taken from the header of the record, because the data contain the name under which the publisher
/// advertised it, which may be another.
McapChannel channel_of(const BagFields& header, std::span<const std::byte> data) {
    const BagFields description(data);
    McapChannel channel;
    channel.topic = header.text("topic");
    channel.message_encoding = "ros1";
    channel.schema.name = description.text("type");
    channel.schema.encoding = "ros1msg";
    channel.schema.data = description.text("message_definition");
    return channel;
}

}  // namespace

BagReader::BagReader(LogFile file, LogProblemHandler on_problem)
    : file_(std::move(file)), section_(open_bytes(file_, on_problem), on_problem) {}

std::optional<McapMessage> BagReader::next() {
    return records_.next(section_, take_bag_record,
                         [this](const BagRecord& record) { return interpret(BagFields(record.header), record.data); });
}

std::optional<McapMessage> BagReader::interpret(const BagFields& header, std::span<const std::byte> data) {
    if (header.opcode() == BagOpcode::message) {
        return message_of(header, data);
    }
    if (header.opcode() == BagOpcode::connection) {
        const auto connection = header.number<std::uint32_t>("conn");
        McapChannel channel = channel_of(header, data);
        channel.id = static_cast<std::uint16_t>(connection);
        channels_.try_emplace(connection, std::move(channel));
    }
    return std::nullopt;
}

std::optional<McapMessage> BagReader::message_of(const BagFields& header, std::span<const std::byte> data) {
    const auto connection = header.number<std::uint32_t>("conn");
    McapMessage message;
    message.channel = find_channel(connection);
    message.log_time_ns = header.time_ns("time");
    message.publish_time_ns = message.log_time_ns;
    message.data = data;
    message.file_offset = records_.offset();
    if (message.channel != nullptr) {
        return message;
    }
    if (undefined_.insert(connection).second) {
        throw Error("connection " + std::to_string(connection) +
                    " is not defined before this message; its other messages are skipped too");
    }
    return std::nullopt;
}

const McapChannel* BagReader::find_channel(std::uint32_t connection) {
    auto channel = channels_.find(connection);
    if (channel == channels_.end() && !std::exchange(index_read_, true)) {
        read_index();
        channel = channels_.find(connection);
    }
    return channel == channels_.end() ? nullptr : &channel->second;
}

void BagReader::read_index() {
    if (section_.index_offset() == 0) {
        return;
    }
    std::vector<std::byte> index;
    try {
        ByteSource bytes = open_bytes(file_, {});
        bytes.skip(section_.index_offset());
        bytes.append_to(index, max_index_bytes);
        McapFieldReader fields(index);
        for (BagRecord record = take_bag_record(fields);; record = take_bag_record(fields)) {
            interpret(BagFields(record.header), record.data);
        }
    } catch (const Error&) {  // NOLINT(bugprone-empty-catch): the index ends here, or it is damaged as well
    }
}

}  // namespace ddtool

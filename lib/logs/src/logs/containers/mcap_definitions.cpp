#include "logs/containers/mcap_definitions.hpp"

#include <string>
#include <utility>

#include "ddtool/base/error.hpp"
#include "logs/containers/mcap_fields.hpp"

namespace ddtool {
namespace {

template <typename Definition>
void add(std::map<std::uint16_t, Definition>& known, Definition definition, const char* kind) {
    const auto earlier = known.find(definition.id);
    if (earlier == known.end()) {
        known.emplace(definition.id, std::move(definition));
    } else if (earlier->second != definition) {
        throw Error(std::string(kind) + " " + std::to_string(definition.id) +
                    " differs from its first definition, which is kept");
    }
}

}  // namespace

void McapDefinitions::add_schema(std::span<const std::byte> record) {
    McapFieldReader fields(record);
    McapSchema schema;
    schema.id = fields.take<std::uint16_t>();
    schema.name = fields.take_string();
    schema.encoding = fields.take_string();
    schema.data = text_of(fields.take_bytes(fields.take<std::uint32_t>()));
    if (schema.id != 0) {  // the specification: a schema with id 0 is invalid, and readers should ignore it
        add(schemas_, std::move(schema), "schema");
    }
}

void McapDefinitions::add_channel(std::span<const std::byte> record) {
    McapFieldReader fields(record);
    McapChannel channel;
    channel.id = fields.take<std::uint16_t>();
    const auto schema_id = fields.take<std::uint16_t>();
    channel.topic = fields.take_string();
    channel.message_encoding = fields.take_string();
    channel.metadata = fields.take_string_map();
    if (schema_id != 0) {
        const auto schema = schemas_.find(schema_id);
        if (schema == schemas_.end()) {
            throw Error("channel " + std::to_string(channel.id) + " (" + channel.topic + ") names schema " +
                        std::to_string(schema_id) + ", which is not defined before it");
        }
        channel.schema = schema->second;
    }
    add(channels_, std::move(channel), "channel");
}

const McapChannel* McapDefinitions::find_channel(std::uint16_t id) const {
    const auto channel = channels_.find(id);
    return channel == channels_.end() ? nullptr : &channel->second;
}

}  // namespace ddtool

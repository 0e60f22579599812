#include "run/foxglove_protocol.hpp"

#include <algorithm>
#include <bit>
#include <cstring>
#include <iterator>
#include <limits>

#include "ddtool/base/error.hpp"
#include "ddtool/system/settings.hpp"
#include "logs/messages/ros2_schema.hpp"

namespace ddtool {
namespace {

static_assert(std::endian::native == std::endian::little, "numbers are copied as they are");

enum class Operation : std::uint8_t { message_data = 1, time = 2 };

template <typename Number>
void append(std::string& bytes, Number number) {
    char raw[sizeof(Number)];
    std::memcpy(raw, &number, sizeof(Number));
    bytes.append(raw, sizeof(Number));
}

/// A value that a client sent, shortened to 40 characters for use in an error message.
std::string quoted(const Json& value) {
    return value.dump(-1, ' ', true, Json::error_handler_t::replace).substr(0, 40);
}

/// Reads an id. The text of the error is meant for the author of the client.
std::uint32_t id(const Json& number) {
    if (!number.is_number_unsigned() || number.get<std::uint64_t>() > std::numeric_limits<std::uint32_t>::max()) {
        throw Error("expected an id from 0 to 4294967295, not " + quoted(number));
    }
    return number.get<std::uint32_t>();
}

std::vector<FoxgloveSubscription> subscriptions(const Json& list) {
    std::vector<FoxgloveSubscription> wanted;
    for (const Json& each : list) {
        wanted.push_back({id(each.at("id")), id(each.at("channelId"))});
    }
    return wanted;
}

std::vector<std::uint32_t> ids(const Json& list) {
    std::vector<std::uint32_t> found;
    std::transform(list.begin(), list.end(), std::back_inserter(found), id);
    return found;
}

FoxgloveRequest request(const Json& message) {
    const std::string operation = message.at("op").get<std::string>();
    if (operation == "subscribe") {
        return {.subscribe = subscriptions(message.at("subscriptions")), .unsubscribe = {}};
    }
    if (operation == "unsubscribe") {
        return {.subscribe = {}, .unsubscribe = ids(message.at("subscriptionIds"))};
    }
    throw Error("operation " + quoted(message.at("op")) + " is not served here; expected subscribe or unsubscribe");
}

}  // namespace

std::string foxglove_server_info(const std::string& name, const std::string& session) {
    return Json{{"op", "serverInfo"}, {"name", name}, {"capabilities", {"time"}}, {"sessionId", session}}.dump();
}

std::string foxglove_advertisement(std::span<const FoxgloveChannel> channels) {
    Json list = Json::array();
    for (const FoxgloveChannel& channel : channels) {
        list.push_back({{"id", channel.id},
                        {"topic", channel.topic},
                        {"encoding", "cdr"},
                        {"schemaName", channel.type_name},
                        {"schemaEncoding", "ros2msg"},
                        {"schema", ros2_schema(channel.type_name)}});
    }
    return Json{{"op", "advertise"}, {"channels", list}}.dump();
}

std::string foxglove_status(FoxgloveStatusLevel level, const std::string& text) {
    // The text may quote bytes from a client, which are not always valid UTF-8.
    return Json{{"op", "status"}, {"level", static_cast<int>(level)}, {"message", text}}.dump(
        -1, ' ', false, Json::error_handler_t::replace);
}

std::string foxglove_time_message(std::int64_t stamp_ns) {
    std::string bytes;
    append(bytes, Operation::time);
    append(bytes, stamp_ns);
    return bytes;
}

std::string foxglove_data_message(std::uint32_t subscription, std::int64_t stamp_ns, std::span<const std::byte> data) {
    std::string bytes;
    bytes.reserve(sizeof(Operation) + sizeof(subscription) + sizeof(stamp_ns) + data.size());
    append(bytes, Operation::message_data);
    append(bytes, subscription);
    append(bytes, stamp_ns);
    bytes.append(reinterpret_cast<const char*>(data.data()), data.size());
    return bytes;
}

FoxgloveRequest parse_foxglove_request(const std::string& text) {
    try {
        return request(parse_json(text, "request"));
    } catch (const Json::exception& error) {
        throw Error(std::string("not a message of the Foxglove WebSocket protocol: ") + error.what());
    }
}

}  // namespace ddtool

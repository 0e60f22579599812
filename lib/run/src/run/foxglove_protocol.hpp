#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

/// The messages of the Foxglove WebSocket protocol, version 1 (https://github.com/foxglove/ws-protocol, docs/spec.md
/// before it moved into the Foxglove SDK): JSON as text, and binary messages, little endian, whose first byte is an
/// operation code.
namespace ddtool {

/// The subprotocol names that a client may request in its handshake; both stand for the same messages.
inline const std::vector<std::string> foxglove_subprotocols{"foxglove.sdk.v1", "foxglove.websocket.v1"};

/// A topic of ROS 2 messages.
struct FoxgloveChannel {
    std::uint32_t id = 0;
    std::string topic;
    std::string type_name;  ///< e.g. "nav_msgs/msg/Path"
};

enum class FoxgloveStatusLevel : int { info = 0, warning = 1, error = 2 };

/// The first message to a client. `session` distinguishes one start of the server from another.
std::string foxglove_server_info(const std::string& name, const std::string& session);
/// Announces the channels with the definitions of their message types.
std::string foxglove_advertisement(std::span<const FoxgloveChannel> channels);
std::string foxglove_status(FoxgloveStatusLevel level, const std::string& text);
/// Binary message: the current time of the data.
std::string foxglove_time_message(std::int64_t stamp_ns);
/// Binary message: the CDR data of one ROS 2 message, for a subscription.
std::string foxglove_data_message(std::uint32_t subscription, std::int64_t stamp_ns, std::span<const std::byte> data);

struct FoxgloveSubscription {
    std::uint32_t id = 0;  ///< chosen by the client
    std::uint32_t channel = 0;
};

/// What a client requests in one message.
struct FoxgloveRequest {
    std::vector<FoxgloveSubscription> subscribe;
    std::vector<std::uint32_t> unsubscribe;  ///< ids of subscriptions
};

/// Parses a text message from a client. Throws Error that says what is wrong with the text, also if it requests an
/// operation that is not supported.
FoxgloveRequest parse_foxglove_request(const std::string& text);

}  // namespace ddtool

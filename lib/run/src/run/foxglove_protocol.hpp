#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

/// The messages of the Foxglove WebSocket protocol, version 1 (https://github.com/foxglove/ws-protocol, docs/spec.md
/// before it moved into the Foxglove SDK): JSON as text, and binary messages with an operation code first, little
/// endian.
namespace ddtool::foxglove {

/// The names a client may ask for in its handshake; both mean the same messages.
inline const std::vector<std::string> subprotocols{"foxglove.sdk.v1", "foxglove.websocket.v1"};

/// A topic of ROS 2 messages.
struct Channel {
    std::uint32_t id = 0;
    std::string topic;
    std::string type_name;  ///< e.g. "nav_msgs/msg/Path"
};

enum class StatusLevel : int { info = 0, warning = 1, error = 2 };

/// The first message to a client. `session` tells one start of the server from another.
std::string server_info(const std::string& name, const std::string& session);
/// The channels there are, with the definitions of their types.
std::string advertisement(std::span<const Channel> channels);
std::string status(StatusLevel level, const std::string& text);
/// Binary: the time of what is played.
std::string time_message(std::int64_t stamp_ns);
/// Binary: a message to a subscriber.
std::string data_message(std::uint32_t subscription, std::int64_t stamp_ns, std::span<const std::byte> data);

struct Subscription {
    std::uint32_t id = 0;  ///< the client's choice
    std::uint32_t channel = 0;
};

/// What a client asked for, in one message.
struct Request {
    std::vector<Subscription> subscribe;
    std::vector<std::uint32_t> unsubscribe;  ///< ids of subscriptions
};

/// Reads a client's text. Throws Error that says what is wrong with it, also for an operation that is not served.
Request parse_request(const std::string& text);

}  // namespace ddtool::foxglove

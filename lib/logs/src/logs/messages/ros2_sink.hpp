#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "logs/messages/ros_codec.hpp"

namespace ddtool {

/// Receives ROS 2 messages on topics, to store them or to send them. The first message of a topic creates it and
/// determines its type. For one thread at a time.
class Ros2Sink {
public:
    Ros2Sink() = default;
    virtual ~Ros2Sink() = default;
    Ros2Sink(const Ros2Sink&) = delete;
    Ros2Sink& operator=(const Ros2Sink&) = delete;

    /// Writes one message of a type of ros_messages.hpp.
    /// \param stamp_ns the log time of the message
    template <typename Message>
    void write(const std::string& topic, std::int64_t stamp_ns, const Message& message) {
        put(topic, Message::type_name, stamp_ns, encode_cdr(message));
    }

protected:
    /// `data` is the message as CDR.
    virtual void put(const std::string& topic, const char* type_name, std::int64_t stamp_ns,
                     std::span<const std::byte> data) = 0;
};

}  // namespace ddtool

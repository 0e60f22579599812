#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <string>

#include "logs/mcap_writer.hpp"
#include "logs/ros2_schema.hpp"
#include "logs/ros_codec.hpp"

namespace ddtool {

/// An MCAP file of ROS 2 messages, as rosbag2 writes them: CDR, with the full definitions of their types. A topic
/// comes into being with its first message.
class Ros2Writer {
public:
    explicit Ros2Writer(const std::filesystem::path& path) : file_(path, options()) {}

    /// Appends one message of a type of ros_messages.hpp; a topic keeps the type of its first message.
    template <typename Message>
    void write(const std::string& topic, std::int64_t stamp_ns, const Message& message) {
        file_.write(channel(topic, Message::type_name), stamp_ns, ros::encode_cdr(message));
    }
    /// Completes the file; without it nothing is left behind.
    void close() { file_.close(); }

private:
    static McapWriterOptions options();
    std::uint16_t channel(const std::string& topic, const char* type_name);

    McapWriter file_;
    std::map<std::string, std::uint16_t, std::less<>> channels_;
};

}  // namespace ddtool

#pragma once

#include <cstddef>
#include <span>
#include <type_traits>
#include <vector>

#include "logs/messages/ros_messages.hpp"

namespace ddtool::test {

/// Serialises a message as ROS 1 does: little endian, no padding, headers with a sequence number.
class Ros1Writer {
public:
    void operator()(const auto&... values) { (write(values), ...); }
    std::vector<std::byte> bytes;

private:
    void write(const auto& message) { message.fields(message, *this); }
    template <typename Value>
    requires std::is_arithmetic_v<Value>
    void write(const Value& value) { append(std::as_bytes(std::span(&value, 1))); }
    void write(const std::string& text) {
        write(static_cast<std::uint32_t>(text.size()));
        append(std::as_bytes(std::span(text)));
    }
    void write(const RosTime& time) {
        write(static_cast<std::uint32_t>(time.ns / 1'000'000'000));
        write(static_cast<std::uint32_t>(time.ns % 1'000'000'000));
    }
    void write(const RosHeader& header) {
        write(std::uint32_t{7});
        (*this)(header.stamp, header.frame_id);
    }
    template <typename Value, std::size_t size>
    void write(const std::array<Value, size>& values) {
        append(std::as_bytes(std::span(values)));
    }
    template <typename Value>
    void write(const std::vector<Value>& values) {
        write(static_cast<std::uint32_t>(values.size()));
        for (const Value& value : values) {
            write(value);
        }
    }
    void append(std::span<const std::byte> more) { bytes.insert(bytes.end(), more.begin(), more.end()); }
};

inline std::vector<std::byte> encode_ros1(const auto& message) {
    Ros1Writer writer;
    writer(message);
    return writer.bytes;
}

}  // namespace ddtool::test

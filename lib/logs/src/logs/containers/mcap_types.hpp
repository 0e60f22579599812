#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <string>

namespace ddtool {

/// The definition of a message type. Names and encodings: MCAP Format Registry (https://mcap.dev/spec/registry).
struct McapSchema {
    std::uint16_t id = 0;  ///< 0: no schema
    std::string name;      ///< e.g. "sensor_msgs/msg/LaserScan"
    std::string encoding;  ///< e.g. "ros2msg"
    std::string data;

    bool operator==(const McapSchema&) const = default;
};

struct McapChannel {
    std::uint16_t id = 0;
    std::string topic;
    std::string message_encoding;  ///< e.g. "cdr"
    std::map<std::string, std::string> metadata;
    McapSchema schema;  ///< empty, with id 0, when the channel has none

    bool operator==(const McapChannel&) const = default;
};

/// A message as it is stored in the file. Times are in nanoseconds since the epoch of the recorder (uint64 in the file,
/// which stays below 2^63 until the year 2262).
struct McapMessage {
    const McapChannel* channel = nullptr;  ///< never null; valid as long as the reader
    std::uint32_t sequence = 0;
    std::int64_t log_time_ns = 0;
    std::int64_t publish_time_ns = 0;
    std::span<const std::byte> data;   ///< valid until the reader's next()
    std::uint64_t file_offset = 0;     ///< of the message's record, or of the chunk that holds it
    const char* offset_unit = "byte";  ///< the unit of file_offset: "byte", or "row" in a database
};

}  // namespace ddtool

#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <sstream>
#include <string>
#include <vector>

#include "ddtool/base/random.hpp"
#include "logs/containers/mcap_writer.hpp"
#include "mcap_read_back.hpp"
#include "system/atomic_file.hpp"
#include "temporary_folder.hpp"

namespace ddtool::test {

/// Reads the file as a stream of unknown length, such as a pipe.
inline ReadBack read_back(const std::string& file) {
    return read_back(ByteSource(std::make_unique<std::istringstream>(file), "test.mcap"));
}

inline std::span<const std::byte> bytes_of(const std::string& text) { return std::as_bytes(std::span(text)); }

/// A file with three channels (two with the same schema, one without any) and `count` messages of pseudorandom content,
/// half of which can be compressed.
inline std::string example_file(const McapWriterOptions& options, std::size_t count) {
    const TemporaryFolder folder;
    const auto path = folder / "example.mcap";
    McapWriter writer(path, options);
    const std::vector<std::uint16_t> channels{
        writer.add_channel("/scan", "cdr", "sensor_msgs/msg/LaserScan", "ros2msg", "float32[] ranges"),
        writer.add_channel("/scan_2", "cdr", "sensor_msgs/msg/LaserScan", "ros2msg", "float32[] ranges"),
        writer.add_channel("/note", "json", "", "", "")};
    RandomStream random{7};
    for (std::size_t index = 0; index < count; ++index) {
        std::string data(random.index(40), 'x');
        for (std::size_t byte = 0; byte < data.size() / 2; ++byte) {
            data[byte] = static_cast<char>(random.index(256));
        }
        // The times step backwards now and then, as they do in some recordings.
        writer.write(channels[random.index(3)], static_cast<std::int64_t>(1000 * index + random.index(3000)),
                     bytes_of(data));
    }
    writer.close();
    return read_file(path);
}

}  // namespace ddtool::test

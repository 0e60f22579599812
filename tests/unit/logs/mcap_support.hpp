#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "base/atomic_file.hpp"
#include "base/error.hpp"
#include "base/random.hpp"
#include "logs/mcap_reader.hpp"
#include "logs/mcap_writer.hpp"

namespace ddtool {

struct OwnedMessage {
    McapChannel channel;
    std::uint32_t sequence = 0;
    std::int64_t log_time_ns = 0;
    std::int64_t publish_time_ns = 0;
    std::string data;

    bool operator==(const OwnedMessage&) const = default;
};

/// All that reading a file gives.
struct ReadBack {
    std::vector<OwnedMessage> messages;
    std::vector<LogProblem> problems;
    std::optional<std::string> error;  ///< what ended the reading
};

inline ReadBack read_back(ByteSource source) {
    ReadBack result;
    try {
        McapReader reader(std::move(source), [&](const LogProblem& problem) { result.problems.push_back(problem); });
        while (const auto message = reader.next()) {
            const auto* text = reinterpret_cast<const char*>(message->data.data());
            result.messages.push_back({*message->channel, message->sequence, message->log_time_ns,
                                       message->publish_time_ns, std::string(text, message->data.size())});
        }
    } catch (const Error& error) {
        result.error = error.what();
    }
    return result;
}

inline ReadBack read_back(const std::string& file) {
    return read_back(ByteSource(std::make_unique<std::istringstream>(file), "test.mcap"));
}

inline std::span<const std::byte> bytes_of(const std::string& text) { return std::as_bytes(std::span(text)); }

inline std::filesystem::path test_path(const std::string& name) {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    std::string unique = std::string(test->test_suite_name()) + "." + test->name() + "." + name;
    std::ranges::replace(unique, '/', '_');
    return std::filesystem::path(testing::TempDir()) / unique;
}

/// A file of three channels (two of one schema, one of none) with `count` messages of pseudorandom content, half of it
/// compressible.
inline std::string example_file(const McapWriterOptions& options, std::size_t count) {
    const auto path = test_path("example.mcap");
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
        // The times step backwards now and then, as some recordings' do.
        writer.write(channels[random.index(3)], static_cast<std::int64_t>(1000 * index + random.index(3000)),
                     bytes_of(data));
    }
    writer.close();
    std::string file = read_file(path);
    std::filesystem::remove(path);
    return file;
}

}  // namespace ddtool

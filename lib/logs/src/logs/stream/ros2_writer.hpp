#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <string>

#include "logs/containers/mcap_writer.hpp"
#include "logs/messages/ros2_schema.hpp"
#include "logs/messages/ros2_sink.hpp"

namespace ddtool {

/// An MCAP file of ROS 2 messages, as rosbag2 writes them: CDR, with the full definitions of their types.
class Ros2Writer : public Ros2Sink {
public:
    explicit Ros2Writer(const std::filesystem::path& path) : file_(path, options()) {}

    /// Completes the file. Without close() no file is left behind.
    void close() { file_.close(); }

protected:
    void put(const std::string& topic, const char* type_name, std::int64_t stamp_ns,
             std::span<const std::byte> data) override;

private:
    static McapWriterOptions options();
    std::uint16_t channel(const std::string& topic, const char* type_name);

    McapWriter file_;
    std::map<std::string, std::uint16_t, std::less<>> channels_;
};

}  // namespace ddtool

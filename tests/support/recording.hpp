#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "logs/containers/mcap_writer.hpp"
#include "logs/messages/ros_codec.hpp"
#include "logs/messages/ros_conversions.hpp"
#include "ros1_writer.hpp"

namespace ddtool::test {

/// A message in the encodings of ROS 1 and ROS 2.
struct RecordedMessage {
    std::string topic;
    std::string ros2_type;
    std::int64_t stamp_ns = 0;
    std::vector<std::byte> ros1;
    std::vector<std::byte> cdr;

    [[nodiscard]] std::string ros1_type() const {
        const std::size_t infix = ros2_type.find("/msg/");
        return ros2_type.substr(0, infix) + ros2_type.substr(infix + 4);
    }
};

using Recording = std::vector<RecordedMessage>;

template <typename Message>
void record(Recording& recording, const std::string& topic, std::int64_t stamp_ns, const Message& message) {
    recording.push_back({topic, Message::type_name, stamp_ns, encode_ros1(message), encode_cdr(message)});
}

/// A recording of a robot that drives straight on for a second, with a scan every 100 ms, odometry every 40 ms, and the
/// laser in front of the robot's centre.
inline Recording example_recording() {
    Recording recording;
    record(recording, "/tf", 10'000'000, transform_message(10'000'000, "base", "laser", {0.2, 0.1, 0.0}));
    for (std::int64_t stamp_ns = 20'000'000; stamp_ns < 1'000'000'000; stamp_ns += 20'000'000) {
        const double x_m = 1e-9 * static_cast<double>(stamp_ns);
        if (stamp_ns % 40'000'000 == 0) {
            record(recording, "/odom", stamp_ns, odometry_message(stamp_ns, "odom", "base", {x_m, 0.0, 0.1}));
        }
        if (stamp_ns % 100'000'000 == 0) {
            RosLaserScan scan;
            scan.header = {{stamp_ns}, "laser"};
            scan.angle_min = -1.0F;
            scan.angle_increment = 0.5F;
            scan.range_max = 10.0F;
            scan.ranges = {1.0F, 2.0F, INFINITY, static_cast<float>(x_m)};
            record(recording, "/scan", stamp_ns, scan);
        }
    }
    return recording;
}

inline void write_mcap(const std::filesystem::path& path, const Recording& recording,
                       const McapWriterOptions& options = {}) {
    McapWriter writer(path, options);
    std::map<std::string, std::uint16_t> channels;
    for (const RecordedMessage& message : recording) {
        if (!channels.contains(message.topic)) {
            channels[message.topic] = writer.add_channel(message.topic, "cdr", message.ros2_type, "ros2msg", "");
        }
        writer.write(channels[message.topic], message.stamp_ns, message.cdr);
    }
    writer.close();
}

}  // namespace ddtool::test

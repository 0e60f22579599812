#include "logs/stream/ros2_writer.hpp"

namespace ddtool {
namespace {

/// The quality of service with which `ros2 bag play` offers a topic, in the notation of rosbag2, as MCAP's profile
/// "ros2" requires. Delivery is reliable. If keeps_last is true, a subscriber that joins late gets the last message,
/// which is necessary for static transforms.
std::string offered_qos(bool keeps_last) {
    const std::string infinite = ":\n    sec: 9223372036\n    nsec: 854775807\n";
    return "- history: 1\n  depth: " + std::string(keeps_last ? "1" : "10") +
           "\n  reliability: 1\n  durability: " + (keeps_last ? "1" : "2") + "\n  deadline" + infinite + "  lifespan" +
           infinite + "  liveliness: 1\n  liveliness_lease_duration" + infinite +
           "  avoid_ros_namespace_conventions: false";
}

}  // namespace

McapWriterOptions Ros2Writer::options() {
    McapWriterOptions options;
    options.profile = "ros2";
    options.chunk_bytes = std::size_t{1} << 18;
    return options;
}

void Ros2Writer::put(const std::string& topic, const char* type_name, std::int64_t stamp_ns,
                     std::span<const std::byte> data) {
    file_.write(channel(topic, type_name), stamp_ns, data);
}

std::uint16_t Ros2Writer::channel(const std::string& topic, const char* type_name) {
    const auto known = channels_.find(topic);
    if (known != channels_.end()) {
        return known->second;
    }
    const bool keeps_last = topic == "/tf_static" || topic == "/map";
    const std::uint16_t id = file_.add_channel(topic, "cdr", type_name, "ros2msg", ros2_schema(type_name),
                                               {{"offered_qos_profiles", offered_qos(keeps_last)}});
    return channels_.emplace(topic, id).first->second;
}

}  // namespace ddtool

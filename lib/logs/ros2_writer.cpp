#include "logs/ros2_writer.hpp"

namespace ddtool {

McapWriterOptions Ros2Writer::options() {
    McapWriterOptions options;
    options.profile = "ros2";
    options.chunk_bytes = std::size_t{1} << 18;
    return options;
}

std::uint16_t Ros2Writer::channel(const std::string& topic, const char* type_name) {
    const auto known = channels_.find(topic);
    if (known != channels_.end()) {
        return known->second;
    }
    const std::uint16_t id = file_.add_channel(topic, "cdr", type_name, "ros2msg", ros::ros2_schema(type_name));
    return channels_.emplace(topic, id).first->second;
}

}  // namespace ddtool

#include <array>

#include "logs/messages/message_decoder.hpp"
#include "logs/stream/cloud_scan.hpp"
#include "message_kinds.hpp"
#include "readers.hpp"

namespace ddtool::fuzz {

/// Decodes the input as a message whose kind the first byte gives.
void read_message(std::span<const char> content) {
    if (content.empty()) {
        return;
    }
    const MessageType& type = message_types.at(static_cast<unsigned char>(content.front()) % message_types.size());
    McapChannel channel;
    channel.topic = type.topic;
    channel.message_encoding = type.encoding;
    channel.schema.name = type.schema;
    const McapMessage message{.channel = &channel, .log_time_ns = 1, .data = std::as_bytes(content.subspan(1))};
    (void)kind_of(channel);
    (void)decode_scan(message);
    if (const std::optional<CloudReading> cloud = decode_cloud(message)) {
        (void)cloud_scan(*cloud, cloud->frame_from_cloud, band_around_unknown, 0);
    }
    (void)decode_imu(message);
    (void)decode_poses(message);
    (void)decode_velocity(message);
    if (is_information(channel)) {
        (void)decode_information(message);
    }
}

}  // namespace ddtool::fuzz

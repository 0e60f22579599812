#include "logs/messages/ros_readings.hpp"

#include "logs/messages/ros_codec.hpp"
#include "logs/messages/ros_conversions.hpp"

namespace ddtool {
namespace {

using Poses = std::vector<PoseReading>;

template <typename Message>
std::optional<Message> decode_ros(std::string_view encoding, std::span<const std::byte> data) {
    return encoding == "ros1" ? decode_ros1<Message>(data) : decode_cdr<Message>(data);
}

Poses ros_readings(const RosOdometry& message) {
    const auto& [stamp, frame_id] = message.header;
    return {{stamp.ns, frame_id, message.child_frame_id, to_isometry(message.pose)}};
}

Poses ros_readings(const RosPoseStamped& message) {
    return {{message.header.stamp.ns, message.header.frame_id, "", to_isometry(message.pose)}};
}

Poses ros_readings(const RosTFMessage& message) {
    Poses poses;
    for (const RosTransformStamped& transform : message.transforms) {
        const auto& [stamp, frame_id] = transform.header;
        poses.push_back({stamp.ns, frame_id, transform.child_frame_id, to_isometry(transform.transform)});
    }
    return poses;
}

template <typename Message>
std::optional<Poses> decode_readings(std::string_view encoding, std::span<const std::byte> data) {
    const std::optional<Message> message = decode_ros<Message>(encoding, data);
    return message ? std::optional(ros_readings(*message)) : std::nullopt;
}

}  // namespace

std::optional<ScanReading> decode_ros_scan(std::string_view encoding, std::span<const std::byte> data) {
    std::optional<RosLaserScan> message = decode_ros<RosLaserScan>(encoding, data);
    if (!message) {
        return std::nullopt;
    }
    ScanReading reading;
    reading.frame_id = message->header.frame_id;
    LaserScan& scan = reading.scan;
    scan.stamp_ns = message->header.stamp.ns;
    scan.angle_min_rad = static_cast<double>(message->angle_min);
    scan.angle_increment_rad = static_cast<double>(message->angle_increment);
    scan.time_increment_s = static_cast<double>(message->time_increment);
    scan.range_min_m = static_cast<double>(message->range_min);
    scan.range_max_m = static_cast<double>(message->range_max);
    scan.ranges_m = std::move(message->ranges);
    return reading;
}

std::optional<Poses> decode_ros_poses(MessageKind kind, std::string_view encoding, std::span<const std::byte> data) {
    switch (kind) {
        case MessageKind::odometry:
            return decode_readings<RosOdometry>(encoding, data);
        case MessageKind::pose:
            return decode_readings<RosPoseStamped>(encoding, data);
        default:
            return decode_readings<RosTFMessage>(encoding, data);
    }
}

std::optional<VelocityReading> decode_ros_velocity(std::string_view encoding, std::span<const std::byte> data) {
    const std::optional<RosTwistStamped> message = decode_ros<RosTwistStamped>(encoding, data);
    if (!message) {
        return std::nullopt;
    }
    return VelocityReading{message->header.stamp.ns, message->header.frame_id, message->linear.x, message->linear.y,
                           message->angular.z};
}

}  // namespace ddtool

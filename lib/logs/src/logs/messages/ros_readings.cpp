#include "logs/messages/ros_readings.hpp"

#include <algorithm>

#include "logs/messages/packed_points.hpp"
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

/// A scan without its ranges, from a message that describes its beams as LaserScan does.
ScanReading without_ranges(const auto& message) {
    ScanReading reading;
    reading.frame_id = message.header.frame_id;
    LaserScan& scan = reading.scan;
    scan.stamp_ns = message.header.stamp.ns;
    scan.angle_min_rad = static_cast<double>(message.angle_min);
    scan.angle_increment_rad = static_cast<double>(message.angle_increment);
    scan.time_increment_s = static_cast<double>(message.time_increment);
    scan.scan_time_s = static_cast<double>(message.scan_time);
    scan.range_min_m = static_cast<double>(message.range_min);
    scan.range_max_m = static_cast<double>(message.range_max);
    return reading;
}

/// The number of the largest intensity of the first `echoes`; 0 if there are none.
std::size_t strongest_of(const std::vector<float>& intensities, std::size_t echoes) {
    std::size_t strongest = 0;
    for (std::size_t index = 1; index < std::min(intensities.size(), echoes); ++index) {
        strongest = intensities[index] > intensities[strongest] ? index : strongest;
    }
    return strongest;
}

}  // namespace

std::optional<ScanReading> decode_ros_scan(std::string_view encoding, std::span<const std::byte> data) {
    std::optional<RosLaserScan> message = decode_ros<RosLaserScan>(encoding, data);
    if (!message) {
        return std::nullopt;
    }
    ScanReading reading = without_ranges(*message);
    reading.scan.ranges_m = std::move(message->ranges);
    return reading;
}

std::optional<ScanReading> decode_ros_echoes(std::string_view encoding, std::span<const std::byte> data, Echo echo) {
    const std::optional<RosMultiEchoLaserScan> message = decode_ros<RosMultiEchoLaserScan>(encoding, data);
    if (!message) {
        return std::nullopt;
    }
    ScanReading reading = without_ranges(*message);
    for (std::size_t beam = 0; beam < message->ranges.size(); ++beam) {
        const std::vector<float>& ranges = message->ranges[beam].echoes;
        const bool has_intensities = beam < message->intensities.size();
        reading.scan.ranges_m.push_back(ranges.empty() ? LaserScan::invalid
                                        : echo == Echo::strongest && has_intensities
                                            ? ranges[strongest_of(message->intensities[beam].echoes, ranges.size())]
                                            : ranges.front());
    }
    return reading;
}

std::optional<CloudReading> decode_ros_cloud(std::string_view encoding, std::span<const std::byte> data) {
    const std::optional<RosPointCloud2> message = decode_ros<RosPointCloud2>(encoding, data);
    if (!message) {
        return std::nullopt;
    }
    PackedPoints packed{.data = std::as_bytes(std::span(message->data)),
                        .fields = {},
                        .rows = message->height,
                        .points_of_row = message->width,
                        .point_step = message->point_step,
                        .row_step = message->row_step,
                        .big_endian = message->is_bigendian != 0};
    for (const RosPointField& field : message->point_fields) {
        packed.fields.push_back({field.name, field.offset, static_cast<PointNumber>(field.datatype)});
    }
    CloudReading reading{.stamp_ns = message->header.stamp.ns, .frame_id = message->header.frame_id};
    unpack_into(reading, packed);
    return reading;
}

std::optional<ImuReading> decode_ros_imu(std::string_view encoding, std::span<const std::byte> data) {
    const std::optional<RosImu> message = decode_ros<RosImu>(encoding, data);
    if (!message || message->angular_velocity_covariance.front() == -1.0) {
        return std::nullopt;
    }
    const auto& [wx, wy, wz] = message->angular_velocity;
    const auto& [ax, ay, az] = message->linear_acceleration;
    return ImuReading{message->header.stamp.ns, message->header.frame_id, {wx, wy, wz}, {ax, ay, az}};
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

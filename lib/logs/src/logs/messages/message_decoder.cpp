#include "logs/messages/message_decoder.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "logs/messages/foxglove_json.hpp"
#include "logs/messages/foxglove_protobuf.hpp"
#include "logs/messages/ros_codec.hpp"
#include "logs/messages/ros_readings.hpp"

namespace ddtool {
namespace {

constexpr std::string_view multi_echo_scan = "sensor_msgs/MultiEchoLaserScan";

struct KnownType {
    std::string_view name;
    MessageKind kind;
};

constexpr std::array<KnownType, 11> ros_types{{
    {"sensor_msgs/LaserScan", MessageKind::scan},
    {multi_echo_scan, MessageKind::scan},
    {"sensor_msgs/PointCloud2", MessageKind::cloud},
    {"sensor_msgs/Imu", MessageKind::inertial},
    {"nav_msgs/Odometry", MessageKind::odometry},
    {"geometry_msgs/PoseStamped", MessageKind::pose},
    {"geometry_msgs/PoseWithCovarianceStamped", MessageKind::pose},
    {"geometry_msgs/TwistStamped", MessageKind::velocity},
    {"geometry_msgs/TwistWithCovarianceStamped", MessageKind::velocity},
    {"tf2_msgs/TFMessage", MessageKind::transforms},
    {"tf/tfMessage", MessageKind::transforms},
}};

constexpr std::array<KnownType, 5> foxglove_types{{
    {"foxglove.LaserScan", MessageKind::scan},
    {"foxglove.PointCloud", MessageKind::cloud},
    {"foxglove.PoseInFrame", MessageKind::pose},
    {"foxglove.FrameTransform", MessageKind::transforms},
    {"foxglove.FrameTransforms", MessageKind::transforms},
}};

MessageKind find_kind(std::span<const KnownType> types, std::string_view name) {
    const auto found =
        std::find_if(types.begin(), types.end(), [&](const KnownType& type) { return type.name == name; });
    return found == types.end() ? MessageKind::other : found->kind;
}

/// Turns the name of a ROS 2 type, package/msg/Type, into that of ROS 1, package/Type.
std::string without_msg(std::string name) {
    constexpr std::string_view infix = "/msg/";
    const std::size_t at = name.find(infix);
    return at == std::string::npos ? name : name.replace(at, infix.size(), "/");
}

void tidy(std::string& frame_id) { frame_id.erase(0, frame_id.starts_with('/') ? 1 : 0); }

bool is_somewhere(const Eigen::Isometry3d& pose) { return (pose.translation().array().abs() < farthest_m).all(); }

/// Puts the identity in place of a rotation that is no number. Returns whether it was one.
bool tidy_rotation(Eigen::Isometry3d& pose) {
    const bool is_rotation = pose.linear().allFinite();
    if (!is_rotation) {
        pose.linear().setIdentity();
    }
    return is_rotation;
}

/// Returns whether there was a stamp.
bool tidy_stamp(std::int64_t& stamp_ns, const McapMessage& message) {
    const bool has_stamp = stamp_ns != 0;
    stamp_ns = has_stamp ? stamp_ns : message.log_time_ns;
    return has_stamp;
}

std::optional<ScanReading> decode_raw_scan(const McapMessage& message, Echo echo) {
    const std::string& encoding = message.channel->message_encoding;
    if (encoding == "protobuf") {
        return foxglove_protobuf_scan(message.data);
    }
    if (encoding == "json") {
        return foxglove_json_scan(message.data);
    }
    return without_msg(message.channel->schema.name) == multi_echo_scan
               ? decode_ros_echoes(encoding, message.data, echo)
               : decode_ros_scan(encoding, message.data);
}

std::optional<CloudReading> decode_raw_cloud(const McapMessage& message) {
    const std::string& encoding = message.channel->message_encoding;
    if (encoding == "protobuf") {
        return foxglove_protobuf_cloud(message.data);
    }
    if (encoding == "json") {
        return foxglove_json_cloud(message.data);
    }
    return decode_ros_cloud(encoding, message.data);
}

std::optional<std::vector<PoseReading>> decode_raw_poses(const McapMessage& message) {
    const std::string& encoding = message.channel->message_encoding;
    const std::string& type = message.channel->schema.name;
    if (encoding == "protobuf") {
        return foxglove_protobuf_poses(type, message.data);
    }
    if (encoding == "json") {
        return foxglove_json_poses(type, message.data);
    }
    return decode_ros_poses(kind_of(*message.channel), encoding, message.data);
}

}  // namespace

MessageKind kind_of(const McapChannel& channel) {
    const std::string& encoding = channel.message_encoding;
    if (encoding == "cdr" || encoding == "ros1") {
        return find_kind(ros_types, without_msg(channel.schema.name));
    }
    if (encoding == "protobuf" || encoding == "json") {
        return find_kind(foxglove_types, channel.schema.name);
    }
    return MessageKind::other;
}

std::optional<ScanReading> decode_scan(const McapMessage& message, Echo echo) {
    std::optional<ScanReading> reading = decode_raw_scan(message, echo);
    if (!reading || !is_somewhere(reading->frame_from_scan)) {
        return std::nullopt;
    }
    tidy(reading->frame_id);
    tidy_rotation(reading->frame_from_scan);
    reading->has_stamp = tidy_stamp(reading->scan.stamp_ns, message);
    return reading;
}

std::optional<CloudReading> decode_cloud(const McapMessage& message) {
    std::optional<CloudReading> reading = decode_raw_cloud(message);
    if (!reading || !is_somewhere(reading->frame_from_cloud)) {
        return std::nullopt;
    }
    tidy(reading->frame_id);
    tidy_rotation(reading->frame_from_cloud);
    tidy_stamp(reading->stamp_ns, message);
    return reading;
}

std::optional<std::vector<PoseReading>> decode_poses(const McapMessage& message) {
    std::optional<std::vector<PoseReading>> readings = decode_raw_poses(message);
    if (!readings || !std::ranges::all_of(*readings, is_somewhere, &PoseReading::frame_from_child)) {
        return std::nullopt;
    }
    for (PoseReading& reading : *readings) {
        tidy(reading.frame_id);
        tidy(reading.child_frame_id);
        reading.has_rotation = tidy_rotation(reading.frame_from_child);
        reading.has_stamp = tidy_stamp(reading.stamp_ns, message);
    }
    return readings;
}

std::optional<ImuReading> decode_imu(const McapMessage& message) {
    std::optional<ImuReading> reading = decode_ros_imu(message.channel->message_encoding, message.data);
    if (!reading || !reading->angular_velocity_rad_per_s.allFinite()) {
        return std::nullopt;
    }
    tidy(reading->frame_id);
    return reading;
}

std::optional<VelocityReading> decode_velocity(const McapMessage& message) {
    std::optional<VelocityReading> reading = decode_ros_velocity(message.channel->message_encoding, message.data);
    const auto is_speed = [](double speed) { return std::abs(speed) < farthest_m; };  // false for NaN
    if (!reading || !is_speed(reading->x_m_s) || !is_speed(reading->y_m_s) || !is_speed(reading->turn_rad_s)) {
        return std::nullopt;
    }
    tidy(reading->frame_id);
    reading->has_stamp = tidy_stamp(reading->stamp_ns, message);
    return reading;
}

std::string fault_of(const McapMessage& message) {
    const std::string encapsulation = message.channel->message_encoding == "cdr" ? unknown_cdr(message.data) : "";
    return encapsulation.empty()
               ? "a damaged message"
               : "a message in " + encapsulation + ", which is not read (expected plain CDR, as ROS 2 writes it),";
}

bool is_information(const McapChannel& channel) {
    return channel.topic == "/fisher_information" && channel.message_encoding == "cdr" &&
           channel.schema.name == RosFloat64MultiArray::type_name;
}

std::optional<Eigen::Matrix3d> decode_information(const McapMessage& message) {
    const auto decoded = decode_cdr<RosFloat64MultiArray>(message.data);
    if (!decoded || decoded->data.size() != 9) {
        return std::nullopt;
    }
    return Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(decoded->data.data());
}

}  // namespace ddtool

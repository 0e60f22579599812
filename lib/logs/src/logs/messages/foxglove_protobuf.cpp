#include "logs/messages/foxglove_protobuf.hpp"

#include <limits>
#include <utility>

#include "foxglove.pb.h"
#include "logs/messages/foxglove_cloud.hpp"
#include "logs/messages/foxglove_scan.hpp"
#include "logs/messages/ros_conversions.hpp"

namespace ddtool {
namespace {

template <typename Message>
std::optional<Message> parse_protobuf(std::span<const std::byte> data) {
    Message message;
    const bool fits = data.size() <= static_cast<std::size_t>(std::numeric_limits<int>::max());
    if (!fits || !message.ParseFromArray(data.data(), static_cast<int>(data.size()))) {
        return std::nullopt;
    }
    return message;
}

Eigen::Isometry3d isometry(const FoxgloveVector3& v, const FoxgloveQuaternion& q) {
    return to_isometry({{v.x(), v.y(), v.z()}, {q.x(), q.y(), q.z(), q.w()}});
}

PoseReading reading(const FoxgloveFrameTransform& message) {
    return {foxglove_stamp_ns(message.timestamp().seconds(), message.timestamp().nanos()), message.parent_frame_id(),
            message.child_frame_id(), isometry(message.translation(), message.rotation())};
}

std::vector<PoseReading> foxglove_readings(const FoxgloveFrameTransform& message) { return {reading(message)}; }

std::vector<PoseReading> foxglove_readings(const FoxgloveFrameTransforms& message) {
    std::vector<PoseReading> poses;
    for (const FoxgloveFrameTransform& transform : message.transforms()) {
        poses.push_back(reading(transform));
    }
    return poses;
}

std::vector<PoseReading> foxglove_readings(const FoxglovePoseInFrame& message) {
    const FoxglovePose& pose = message.pose();
    return {{foxglove_stamp_ns(message.timestamp().seconds(), message.timestamp().nanos()), message.frame_id(), "",
             isometry(pose.position(), pose.orientation())}};
}

template <typename Message>
std::optional<std::vector<PoseReading>> decode_foxglove(std::span<const std::byte> data) {
    const std::optional<Message> message = parse_protobuf<Message>(data);
    return message ? std::optional(foxglove_readings(*message)) : std::nullopt;
}

}  // namespace

std::optional<ScanReading> foxglove_protobuf_scan(std::span<const std::byte> data) {
    const std::optional<FoxgloveLaserScan> message = parse_protobuf<FoxgloveLaserScan>(data);
    if (!message) {
        return std::nullopt;
    }
    ScanReading scan;
    scan.frame_id = message->frame_id();
    scan.frame_from_scan = isometry(message->pose().position(), message->pose().orientation());
    scan.scan.stamp_ns = foxglove_stamp_ns(message->timestamp().seconds(), message->timestamp().nanos());
    scan.scan.ranges_m.assign(message->ranges().begin(), message->ranges().end());
    set_foxglove_angles(scan.scan, message->start_angle(), message->end_angle());
    return scan;
}

std::optional<CloudReading> foxglove_protobuf_cloud(std::span<const std::byte> data) {
    const std::optional<FoxglovePointCloud> message = parse_protobuf<FoxglovePointCloud>(data);
    if (!message) {
        return std::nullopt;
    }
    std::vector<PackedField> fields;
    for (const FoxglovePackedElementField& field : message->fields()) {
        fields.push_back({field.name(), field.offset(), foxglove_number(field.type())});
    }
    CloudReading cloud{.stamp_ns = foxglove_stamp_ns(message->timestamp().seconds(), message->timestamp().nanos()),
                       .frame_id = message->frame_id(),
                       .frame_from_cloud = isometry(message->pose().position(), message->pose().orientation())};
    unpack_foxglove(cloud, std::as_bytes(std::span(message->data())), std::move(fields), message->point_stride());
    return cloud;
}

std::optional<std::vector<PoseReading>> foxglove_protobuf_poses(std::string_view type,
                                                                std::span<const std::byte> data) {
    if (type == "foxglove.PoseInFrame") {
        return decode_foxglove<FoxglovePoseInFrame>(data);
    }
    return type == "foxglove.FrameTransforms" ? decode_foxglove<FoxgloveFrameTransforms>(data)
                                              : decode_foxglove<FoxgloveFrameTransform>(data);
}

}  // namespace ddtool

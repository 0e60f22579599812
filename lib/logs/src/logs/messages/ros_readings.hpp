#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "logs/messages/message_decoder.hpp"

namespace ddtool {

/// Decodes sensor_msgs LaserScan from the encoding "cdr" or "ros1". Returns nullopt if the bytes are not such a
/// message.
std::optional<ScanReading> decode_ros_scan(std::string_view encoding, std::span<const std::byte> data);

/// Decodes nav_msgs Odometry, geometry_msgs PoseStamped or PoseWithCovarianceStamped (which begins like the other), or
/// tf2_msgs TFMessage; `kind` says which. Returns nullopt if
/// the bytes are not such a message.
std::optional<std::vector<PoseReading>> decode_ros_poses(MessageKind kind, std::string_view encoding,
                                                         std::span<const std::byte> data);

/// Decodes geometry_msgs TwistStamped or TwistWithCovarianceStamped, which begins like the other. Returns nullopt if
/// the bytes are not such a message.
std::optional<VelocityReading> decode_ros_velocity(std::string_view encoding, std::span<const std::byte> data);

}  // namespace ddtool

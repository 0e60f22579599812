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

/// Decodes sensor_msgs Imu from the encoding "cdr" or "ros1". Returns nullopt if the bytes are not such a message, or
/// if the sensor says that it does not measure angular velocities.
std::optional<ImuReading> decode_ros_imu(std::string_view encoding, std::span<const std::byte> data);
/// Decodes sensor_msgs MultiEchoLaserScan from these encodings. A beam without an echo is invalid, because its drivers
/// leave out both missing returns and failed measurements. Where the message has no intensities, the first echo is the
/// strongest. Returns nullopt if the bytes are not such a message.
std::optional<ScanReading> decode_ros_echoes(std::string_view encoding, std::span<const std::byte> data, Echo echo);

/// Decodes sensor_msgs PointCloud2 from these encodings. Returns nullopt if the bytes are not such a message; a message
/// whose points cannot be read has a CloudReading::fault.
std::optional<CloudReading> decode_ros_cloud(std::string_view encoding, std::span<const std::byte> data);

/// Decodes nav_msgs Odometry, geometry_msgs PoseStamped or PoseWithCovarianceStamped (which begins like the other), or
/// tf2_msgs TFMessage; `kind` says which. Returns nullopt if
/// the bytes are not such a message.
std::optional<std::vector<PoseReading>> decode_ros_poses(MessageKind kind, std::string_view encoding,
                                                         std::span<const std::byte> data);

/// Decodes geometry_msgs TwistStamped or TwistWithCovarianceStamped, which begins like the other. Returns nullopt if
/// the bytes are not such a message.
std::optional<VelocityReading> decode_ros_velocity(std::string_view encoding, std::span<const std::byte> data);

}  // namespace ddtool

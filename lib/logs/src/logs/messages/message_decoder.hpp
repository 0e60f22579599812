#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "logs/containers/mcap_types.hpp"
#include "logs/messages/readings.hpp"

namespace ddtool {

enum class MessageKind {
    other,
    scan,        ///< sensor_msgs LaserScan and MultiEchoLaserScan, foxglove LaserScan
    cloud,       ///< sensor_msgs PointCloud2, foxglove PointCloud
    odometry,    ///< nav_msgs Odometry
    pose,        ///< geometry_msgs PoseStamped, PoseWithCovarianceStamped, foxglove PoseInFrame
    inertial,    ///< sensor_msgs Imu
    velocity,    ///< geometry_msgs TwistStamped, TwistWithCovarianceStamped
    transforms,  ///< tf2_msgs TFMessage, foxglove FrameTransform(s)
};

/// The kind of messages on a channel, by the name of its schema and its message encoding: ROS types in "cdr" and
/// "ros1", and Foxglove's types in "protobuf" and "json".
MessageKind kind_of(const McapChannel& channel);

/// Decodes a message of the kind scan. A leading '/' is removed from frame names, and a stamp of zero is replaced by
/// the log time, which the reading tells. Returns nullopt if the bytes are not such a message, or contain a position
/// that is not finite or further away than farthest_m.
/// \param echo which one a beam of several has as its range
std::optional<ScanReading> decode_scan(const McapMessage& message, Echo echo = Echo::first);

/// Decodes a message of the kind cloud by the same rules. If only its points cannot be read, it has a fault.
std::optional<CloudReading> decode_cloud(const McapMessage& message);

/// Decodes a message of the kind inertial by the same rules. Returns nullopt, too, if its angular velocities are no
/// numbers or not measured.
std::optional<ImuReading> decode_imu(const McapMessage& message);

/// Whether the messages of a kind hold poses or transforms, or velocities, from which PoseReader makes poses.
inline bool has_poses(MessageKind kind) {
    return kind == MessageKind::odometry || kind == MessageKind::pose || kind == MessageKind::transforms ||
           kind == MessageKind::velocity;
}

/// Decodes a message that holds poses or transforms by the same rules: one reading for odometry and poses, any number
/// for transforms.
std::optional<std::vector<PoseReading>> decode_poses(const McapMessage& message);

/// Decodes a message of the kind velocity by the same rules. Returns nullopt for a velocity that is not finite, too.
std::optional<VelocityReading> decode_velocity(const McapMessage& message);

/// What is wrong with a message that cannot be decoded, as a noun: "a damaged message".
std::string fault_of(const McapMessage& message);

/// Whether the channel is the simulator's /fisher_information, the Fisher information of each scan about the true pose.
bool is_information(const McapChannel& channel);

/// Decodes that information, over (x, y, theta) in the robot's frame, in 1/m^2, 1/m and 1. The log time of the message
/// is the stamp of the scan. Returns nullopt if the bytes are not a 3 x 3 matrix.
std::optional<Eigen::Matrix3d> decode_information(const McapMessage& message);

}  // namespace ddtool

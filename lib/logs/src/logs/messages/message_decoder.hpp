#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "logs/containers/mcap_types.hpp"
#include "logs/messages/readings.hpp"

namespace ddtool {

enum class MessageKind {
    other,
    scan,        ///< sensor_msgs LaserScan, foxglove LaserScan
    odometry,    ///< nav_msgs Odometry
    pose,        ///< geometry_msgs PoseStamped, foxglove PoseInFrame
    transforms,  ///< tf2_msgs TFMessage, foxglove FrameTransform(s)
};

/// What a channel carries, by its schema's name and message encoding: ROS types in "cdr" and "ros1", Foxglove's in
/// "protobuf" and "json".
MessageKind kind_of(const McapChannel& channel);

/// Decodes a message of kind scan. Frame names lose a leading '/', a stamp of zero becomes the log time. None when the
/// bytes are no such message, or name a place that is no number or beyond farthest_m.
std::optional<ScanReading> decode_scan(const McapMessage& message);

/// The same for the other kinds: one reading for odometry and poses, any number for transforms.
std::optional<std::vector<PoseReading>> decode_poses(const McapMessage& message);

/// Whether the channel is the simulator's /fisher_information: what each scan tells of the true pose.
bool is_information(const McapChannel& channel);

/// That information, over (x, y, theta); the log time is the scan's stamp. None when the bytes are no 3 x 3 matrix.
std::optional<Eigen::Matrix3d> decode_information(const McapMessage& message);

}  // namespace ddtool

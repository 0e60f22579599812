#pragma once

#include <array>

namespace ddtool::fuzz {

struct MessageType {
    const char* topic;
    const char* encoding;
    const char* schema;
};

/// The kinds of message from which the first byte of an input chooses, for the reader "message".
inline constexpr std::array<MessageType, 31> message_types{{
    {"/scan", "cdr", "sensor_msgs/msg/LaserScan"},
    {"/odom", "cdr", "nav_msgs/msg/Odometry"},
    {"/pose", "cdr", "geometry_msgs/msg/PoseStamped"},
    {"/tf", "cdr", "tf2_msgs/msg/TFMessage"},
    {"/scan", "ros1", "sensor_msgs/LaserScan"},
    {"/odom", "ros1", "nav_msgs/Odometry"},
    {"/pose", "ros1", "geometry_msgs/PoseStamped"},
    {"/tf", "ros1", "tf/tfMessage"},
    {"/scan", "protobuf", "foxglove.LaserScan"},
    {"/pose", "protobuf", "foxglove.PoseInFrame"},
    {"/tf", "protobuf", "foxglove.FrameTransform"},
    {"/tf", "protobuf", "foxglove.FrameTransforms"},
    {"/scan", "json", "foxglove.LaserScan"},
    {"/pose", "json", "foxglove.PoseInFrame"},
    {"/tf", "json", "foxglove.FrameTransform"},
    {"/tf", "json", "foxglove.FrameTransforms"},
    {"/fisher_information", "cdr", "std_msgs/msg/Float64MultiArray"},
    {"/points", "cdr", "sensor_msgs/msg/PointCloud2"},
    {"/points", "ros1", "sensor_msgs/PointCloud2"},
    {"/points", "protobuf", "foxglove.PointCloud"},
    {"/points", "json", "foxglove.PointCloud"},
    {"/scan", "cdr", "sensor_msgs/msg/MultiEchoLaserScan"},
    {"/scan", "ros1", "sensor_msgs/MultiEchoLaserScan"},
    {"/twist", "cdr", "geometry_msgs/msg/TwistStamped"},
    {"/twist", "ros1", "geometry_msgs/TwistStamped"},
    {"/twist", "cdr", "geometry_msgs/msg/TwistWithCovarianceStamped"},
    {"/twist", "ros1", "geometry_msgs/TwistWithCovarianceStamped"},
    {"/pose", "cdr", "geometry_msgs/msg/PoseWithCovarianceStamped"},
    {"/pose", "ros1", "geometry_msgs/PoseWithCovarianceStamped"},
    {"/imu", "cdr", "sensor_msgs/msg/Imu"},
    {"/imu", "ros1", "sensor_msgs/Imu"},
}};

}  // namespace ddtool::fuzz

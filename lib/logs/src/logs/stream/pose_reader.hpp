#pragma once

#include <optional>
#include <vector>

#include "ddtool/robot/pose2.hpp"
#include "logs/messages/message_decoder.hpp"

namespace ddtool {

/// Reads the poses of one topic, of any kind but scans. From velocities they are integrated: the velocity between two
/// messages is the mean of both, the first pose is the origin, and the frame is that of the robot, or none if the
/// velocities are given in the axes of a fixed frame (names_fixed_frame()).
class PoseReader {
public:
    /// Nullopt if the message cannot be decoded.
    std::optional<std::vector<PoseReading>> read(const McapMessage& message);

private:
    PoseReading integrated(const VelocityReading& velocity);

    std::optional<VelocityReading> before_;
    Pose2 odom_from_robot_;
};

}  // namespace ddtool

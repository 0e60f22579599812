#include "logs/stream/pose_reader.hpp"

#include "logs/messages/ros_conversions.hpp"
#include "logs/stream/topic_names.hpp"
#include "robot/stamps.hpp"

namespace ddtool {

std::optional<std::vector<PoseReading>> PoseReader::read(const McapMessage& message) {
    if (kind_of(*message.channel) != MessageKind::velocity) {
        return decode_poses(message);
    }
    const std::optional<VelocityReading> velocity = decode_velocity(message);
    if (!velocity) {
        return std::nullopt;
    }
    return std::vector{integrated(*velocity)};
}

PoseReading PoseReader::integrated(const VelocityReading& velocity) {
    const bool is_fixed = names_fixed_frame(velocity.frame_id);
    if (before_ && velocity.stamp_ns > before_->stamp_ns) {
        const double step_s = seconds_between(before_->stamp_ns, velocity.stamp_ns);
        const double turn_rad = step_s * (before_->turn_rad_s + velocity.turn_rad_s) / 2.0;
        const double x_m = step_s * (before_->x_m_s + velocity.x_m_s) / 2.0;
        const double y_m = step_s * (before_->y_m_s + velocity.y_m_s) / 2.0;
        Pose2& pose = odom_from_robot_;
        // The heading in the middle of the step: the chord of the arc.
        const Pose2 axes{pose.x_m, pose.y_m, is_fixed ? 0.0 : pose.theta_rad + turn_rad / 2.0};
        const Pose2 moved = axes * Pose2{x_m, y_m, 0.0};
        pose = {moved.x_m, moved.y_m, wrap_angle(pose.theta_rad + turn_rad)};
    }
    before_ = velocity;
    PoseReading reading{velocity.stamp_ns, is_fixed ? velocity.frame_id : "", is_fixed ? "" : velocity.frame_id,
                        to_isometry(to_ros_pose(odom_from_robot_))};
    reading.has_stamp = velocity.has_stamp;
    return reading;
}

}  // namespace ddtool

#include "logs/stream/frame_writer.hpp"

#include <algorithm>

#include "logs/messages/ros_conversions.hpp"

namespace ddtool {
namespace {

constexpr const char* world = "world";
constexpr const char* odom = "odom";
constexpr const char* robot = "base_link";
constexpr const char* laser = "laser";

}  // namespace

void FrameWriter::write(const SensorFrame& frame) {
    const std::int64_t stamp_ns = frame.scan.stamp_ns;
    log_time_ns_ = std::max(log_time_ns_, stamp_ns);
    if (robot_from_laser_ != frame.robot_from_laser) {
        write_mounting(stamp_ns, frame.robot_from_laser);
    }
    file_.write("/odom", log_time_ns_, odometry_message(stamp_ns, odom, robot, frame.odom_from_robot));
    file_.write("/tf", log_time_ns_, transform_message(stamp_ns, odom, robot, frame.odom_from_robot));
    if (frame.world_from_robot) {
        file_.write("/ground_truth", log_time_ns_, odometry_message(stamp_ns, world, robot, *frame.world_from_robot));
    }
    file_.write("/scan", log_time_ns_, scan_message(frame.scan, laser));
}

void FrameWriter::write_mounting(std::int64_t stamp_ns, const Pose2& robot_from_laser) {
    robot_from_laser_ = robot_from_laser;
    file_.write("/tf_static", log_time_ns_, transform_message(stamp_ns, robot, laser, robot_from_laser));
}

}  // namespace ddtool

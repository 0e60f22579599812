#include "logs/stream/frame_writer.hpp"

#include <algorithm>

#include "logs/messages/ros_conversions.hpp"
#include "logs/stream/laser_mounting.hpp"

namespace ddtool {
namespace {

constexpr const char* world = "world";
constexpr const char* odom = "odom";
constexpr const char* robot = "base_link";
constexpr const char* laser = "laser";
/// If there are more, the frame of the first is used again, because each line of a CARMEN log may have its own.
constexpr std::size_t most_lasers = 16;

}  // namespace

void FrameWriter::write(const SensorFrame& frame) {
    const std::int64_t stamp_ns = frame.scan.stamp_ns;
    log_time_ns_ = std::max(log_time_ns_, stamp_ns);
    const std::string laser_frame = frame_of(stamp_ns, frame.robot_from_laser);
    file_.write("/odom", log_time_ns_, odometry_message(stamp_ns, odom, robot, frame.odom_from_robot));
    file_.write("/tf", log_time_ns_, transform_message(stamp_ns, odom, robot, frame.odom_from_robot));
    if (frame.world_from_robot) {
        file_.write("/ground_truth", log_time_ns_, odometry_message(stamp_ns, world, robot, *frame.world_from_robot));
    }
    const std::string topic = frame.lidar == 0 ? "/scan" : "/scan_" + std::to_string(frame.lidar + 1);
    file_.write(topic, log_time_ns_, scan_message(frame.scan, laser_frame));
}

std::string FrameWriter::frame_of(std::int64_t stamp_ns, const Pose2& robot_from_laser) {
    const auto same = [&](const Pose2& known) { return is_same_mounting(known, robot_from_laser); };
    const auto known = std::find_if(robot_from_lasers_.begin(), robot_from_lasers_.end(), same);
    const auto number = static_cast<std::size_t>(known - robot_from_lasers_.begin()) % most_lasers;
    const std::string name = number == 0 ? laser : laser + ("_" + std::to_string(number + 1));
    if (known == robot_from_lasers_.end()) {
        file_.write("/tf_static", log_time_ns_, transform_message(stamp_ns, robot, name, robot_from_laser));
        if (robot_from_lasers_.size() < most_lasers) {
            robot_from_lasers_.push_back(robot_from_laser);
        } else {
            robot_from_lasers_.front() = robot_from_laser;
        }
    }
    return name;
}

}  // namespace ddtool

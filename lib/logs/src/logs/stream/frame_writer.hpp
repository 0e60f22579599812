#pragma once

#include <cstdint>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

#include "ddtool/robot/pose2.hpp"
#include "ddtool/robot/sensor_stream.hpp"
#include "logs/stream/ros2_writer.hpp"

namespace ddtool {

/// Writes sensor frames as a log of ROS 2 messages: /scan (LaserScan; /scan_2 and so on for the other lidars), /odom
/// and, if it is known, /ground_truth (Odometry), /tf (odom from base_link) and /tf_static (base_link from laser; from
/// laser_2 and so on for scans of a lidar that is mounted elsewhere). open_log() can read the file. Throws OutputError
/// naming the file.
class FrameWriter {
public:
    explicit FrameWriter(const std::filesystem::path& path) : file_(path) {}

    void write(const SensorFrame& frame);
    /// Completes the file. Without close() no file is left behind.
    void close() { file_.close(); }

private:
    /// The frame of a laser that is mounted like this. Writes its transform when it is new.
    std::string frame_of(std::int64_t stamp_ns, const Pose2& robot_from_laser);

    Ros2Writer file_;
    std::vector<Pose2> robot_from_lasers_;  ///< as written, one for each frame
    /// Never steps back, so that programs that read by log time keep the order of the frames. The stamps in the
    /// messages may step back.
    std::int64_t log_time_ns_ = std::numeric_limits<std::int64_t>::min();
};

}  // namespace ddtool

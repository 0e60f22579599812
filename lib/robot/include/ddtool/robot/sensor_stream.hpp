#pragma once

#include <memory>
#include <optional>

#include "ddtool/robot/laser_scan.hpp"
#include "ddtool/robot/pose2.hpp"

namespace ddtool {

class ScanTruth;

/// A scan with what was known of the robot when it was taken.
struct SensorFrame {
    LaserScan scan;
    Pose2 robot_from_laser;                 ///< the lidar's mounting
    Pose2 odom_from_robot;                  ///< odometry, interpolated to the scan's stamp
    std::optional<Pose2> world_from_robot;  ///< ground truth at the scan's stamp, where the source has it
};

/// Frames in the order of the source. Logs and the simulator make it, the filter eats it; neither knows the other.
class SensorStream {
public:
    SensorStream() = default;
    virtual ~SensorStream() = default;
    SensorStream(const SensorStream&) = delete;
    SensorStream& operator=(const SensorStream&) = delete;

    /// The next frame; none at the end.
    virtual std::optional<SensorFrame> next() = 0;
    /// Share of the source already read, 0..1, for progress; 0 where its length is unknown.
    [[nodiscard]] virtual double fraction_read() const = 0;
    /// From now on what the source knows of a scan that no robot knows is written into `truth` before its frame is
    /// given out. A source that knows no more than a robot, as most do, leaves it empty.
    virtual void tell_truth(std::shared_ptr<ScanTruth> /*truth*/) {}
};

}  // namespace ddtool

#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "ddtool/robot/laser_scan.hpp"
#include "ddtool/robot/pose2.hpp"

namespace ddtool {

class ScanTruth;

/// What the odometry says of the motion from one frame to the next.
enum class OdometryStep {
    measured,
    guessed,  ///< part of it fills a gap in the odometry: a place to start looking for the motion in the scans
    unknown,  ///< nothing: there is no odometry, or it is stuck, or it has started again
};

/// A scan, with what is known about the robot at its stamp.
struct SensorFrame {
    LaserScan scan;
    Pose2 robot_from_laser;                           ///< the pose of the lidar on the robot
    Pose2 odom_from_robot;                            ///< odometry, interpolated to the scan's stamp
    std::optional<Pose2> world_from_robot;            ///< the true pose at the stamp of the scan, if the source has it
    OdometryStep odom_step = OdometryStep::measured;  ///< what odom_from_robot says of the motion since the last frame
    /// How the robot moved during the scan, by the odometry: its poses in its frame at the stamp, at equal steps from
    /// the first beam to the last (robot/sweep.hpp). Empty where all beams count as measured at the stamp.
    std::vector<Pose2> sweep = {};
    std::size_t lidar = 0;  ///< which of the robot's lidars took the scan
    /// Scans of other lidars that are used together with this one, each with what is known at its own stamp. Between
    /// their stamps and this one the robot moved as odom_from_robot says.
    std::vector<SensorFrame> joined = {};
};

/// A sequence of frames in the order of the source. Logs and the simulator produce streams and the filter consumes
/// them, so that neither depends on the other. For one thread at a time.
class SensorStream {
public:
    SensorStream() = default;
    virtual ~SensorStream() = default;
    SensorStream(const SensorStream&) = delete;
    SensorStream& operator=(const SensorStream&) = delete;

    /// The next frame; nullopt at the end.
    virtual std::optional<SensorFrame> next() = 0;
    /// The share of the source that has been read, 0..1, for progress; 0 if the length of the source is unknown.
    [[nodiscard]] virtual double fraction_read() const = 0;
    /// From now on what the source knows of a scan that no robot knows is written into `truth` before its frame is
    /// given out. A source that knows no more than a robot, as most do, leaves it empty.
    virtual void tell_truth(const std::shared_ptr<ScanTruth>& /*truth*/) {}
};

}  // namespace ddtool

#pragma once

#include <cstddef>
#include <optional>

#include "ddtool/filter/scan_insertion.hpp"
#include "ddtool/robot/sensor_stream.hpp"
#include "ddtool/robot/trajectory.hpp"

namespace ddtool::compare {

/// The map that a trajectory makes of a log: scans entered at its poses, whatever method they came from, so that the
/// maps of different methods differ by the trajectories alone.
class TrajectoryMap {
public:
    /// world_from_robot, in any order.
    explicit TrajectoryMap(Trajectory trajectory);

    /// Enters the frame if the robot has moved since the last one that was; leaves out those before and after the
    /// trajectory.
    void add(const SensorFrame& frame);
    [[nodiscard]] const OccupancyGrid& grid() const { return grid_; }

private:
    Trajectory sorted_;
    OccupancyGrid grid_{OccupancySettings{}};
    ScanInserter inserter_;
    std::optional<Pose2> last_;
};

}  // namespace ddtool::compare

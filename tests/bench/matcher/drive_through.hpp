#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "bench_worlds.hpp"
#include "ddtool/filter/rbpf.hpp"
#include "ddtool/robot/sensor_stream.hpp"
#include "sim/lidar.hpp"

namespace ddtool::matcher_bench {

/// A place of a drive at which the filter would make an update.
struct Place {
    SensorFrame frame;       ///< the scan; the odometry is the true pose, world_from_robot
    double way_m = 0.0;      ///< driven so far
    double along_rad = 0.0;  ///< the direction, in the world, along which errors are measured
    /// Fisher information of the scan about (x, y, theta) in the robot's frame, given the true walls.
    Eigen::Matrix3d information = Eigen::Matrix3d::Zero();

    [[nodiscard]] const Pose2& pose() const { return frame.odom_from_robot; }
};

/// The places along the route of a world, with a scan of each. The lidar is at the robot's origin.
/// \param filter says after which motion the filter updates
/// \param seed of the noise of the scans
std::vector<Place> drive_through(const BenchWorld& world, const sim::LidarSettings& lidar, const RbpfSettings& filter,
                                 std::uint64_t seed);

}  // namespace ddtool::matcher_bench

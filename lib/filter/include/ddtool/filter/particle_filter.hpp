#pragma once

#include <Eigen/Core>
#include <optional>

#include "ddtool/filter/occupancy_grid.hpp"
#include "ddtool/filter/odometry_model.hpp"
#include "ddtool/filter/update.hpp"
#include "ddtool/robot/sensor_stream.hpp"
#include "ddtool/robot/trajectory.hpp"

namespace ddtool {

/// A particle filter that takes one frame at a time and maps. An object may be used by one thread at a time.
class ParticleFilter {
public:
    ParticleFilter() = default;
    virtual ~ParticleFilter() = default;
    ParticleFilter(const ParticleFilter&) = delete;
    ParticleFilter& operator=(const ParticleFilter&) = delete;

    /// Processes the next scan. Returns nothing if the robot has hardly moved since the last update. The first scan
    /// starts the map and counts as an update. Throws MapTooLarge if the maps cannot take the scan; the trajectory then
    /// ends before this scan, though the particles already have their poses at it and some of their maps contain it.
    virtual std::optional<Update> update(const SensorFrame& frame) = 0;

    /// The map of the best particle. Needs an update before it.
    [[nodiscard]] virtual const OccupancyGrid& map() const = 0;
    /// world_from_robot at the latest scan, from the best particle. Needs an update before it.
    [[nodiscard]] virtual Pose2 pose() const = 0;
    /// Covariance of pose() (x, y, theta in the world; m^2, m rad, rad^2): that of the last update plus the uncertainty
    /// of the odometry since. Needs an update before it.
    [[nodiscard]] virtual Eigen::Matrix3d pose_covariance() const = 0;
    /// A pose for every scan so far, from the past of the best particle.
    [[nodiscard]] Trajectory trajectory() const {
        Trajectory all;
        visit_trajectory([&](const StampedPose& pose) { all.push_back(pose); });
        return all;
    }
    /// Calls `visit` with each pose of trajectory(), without a copy of them all, which a long drive makes large.
    virtual void visit_trajectory(const PoseVisitor& visit) const = 0;
    /// What has been learnt of the odometry; empty if the method learns nothing of it.
    [[nodiscard]] virtual std::optional<OdometryState> odometry_state() const { return std::nullopt; }
};

}  // namespace ddtool

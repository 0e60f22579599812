#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "ddtool/robot/sensor_stream.hpp"
#include "ddtool/robot/trajectory.hpp"
#include "sim/drive.hpp"
#include "sim/inertial_sensor.hpp"
#include "sim/lidar.hpp"
#include "sim/ray_caster.hpp"
#include "sim/wheel_odometry.hpp"
#include "sim/world.hpp"

namespace ddtool::sim {

struct SimulationSettings {
    std::uint64_t seed = 1;
    std::int64_t start_ns = 1'700'000'000'000'000'000;  ///< stamp of the first pose
    Pose2 robot_from_laser;
    std::vector<Pose2>
        more_lasers;  ///< robot_from_laser of further lidars of the same kind; only a log has their scans
    LidarSettings lidar;
    OdometrySettings odometry;
    ImuSettings imu;
    DriveSettings drive;
};

struct SimulatedFrame {
    SensorFrame frame;  ///< with the true pose
    /// The Fisher information of the scan without noise or motion distortion, at the true pose; see
    /// fisher_information.hpp.
    Eigen::Matrix3d fisher_information = Eigen::Matrix3d::Zero();
};

/// A drive through a world. The true path and the odometry are computed in the constructor, each scan when it is asked
/// for. Random numbers come from one stream per (seed, purpose, scan or step), so that frames may be asked for in any
/// order and from many threads, and always have the same bytes.
class Simulation {
public:
    Simulation(const World& world, const SimulationSettings& settings);

    [[nodiscard]] const SimulationSettings& settings() const { return settings_; }
    /// world_from_robot, every 10 ms.
    [[nodiscard]] const Trajectory& truth() const { return truth_; }
    /// world_from_robot at the stamps of the first lidar's scans.
    [[nodiscard]] Trajectory truth_at_scans() const;
    /// odom_from_robot at the odometry's rate; the odom frame is the robot's at the start.
    [[nodiscard]] const Trajectory& odometry() const { return odometry_; }
    /// Empty without an inertial sensor. Only a log has them: the frames are those of the wheels' odometry.
    [[nodiscard]] std::vector<StampedTurnRate> turn_rates() const {
        return simulate_gyro(truth_, settings_.imu, settings_.seed);
    }
    /// The first lidar has the number 0.
    [[nodiscard]] std::size_t lidar_count() const { return 1 + settings_.more_lasers.size(); }
    [[nodiscard]] const Pose2& robot_from_laser(std::size_t lidar = 0) const;
    [[nodiscard]] std::size_t frame_count(std::size_t lidar = 0) const;
    /// The stamp of the frame. The lidars take turns: their scans are spread evenly over the time of a turn.
    [[nodiscard]] std::int64_t stamp_ns(std::size_t index, std::size_t lidar = 0) const;
    [[nodiscard]] SimulatedFrame frame(std::size_t index, std::size_t lidar = 0) const;

private:
    [[nodiscard]] std::vector<Pose2> laser_poses(const LaserScan& scan, const Pose2& robot_from_laser) const;

    SimulationSettings settings_;
    RayCaster caster_;
    Trajectory truth_;
    Trajectory odometry_;
};

}  // namespace ddtool::sim

#include "sim/simulation.hpp"

#include <algorithm>
#include <cmath>

#include "robot/sweep.hpp"
#include "sim/fisher_information.hpp"
#include "sim/random_purpose.hpp"

namespace ddtool::sim {
namespace {

constexpr std::int64_t truth_step_ns = 10'000'000;

}  // namespace

Simulation::Simulation(const World& world, const SimulationSettings& settings)
    : settings_(settings),
      caster_(world),
      truth_(drive(world.route, settings.drive, settings.start_ns, truth_step_ns)),
      odometry_(simulate_odometry(truth_, settings.odometry, settings.seed)) {}

const Pose2& Simulation::robot_from_laser(std::size_t lidar) const {
    return lidar == 0 ? settings_.robot_from_laser : settings_.more_lasers.at(lidar - 1);
}

std::size_t Simulation::frame_count(std::size_t lidar) const {
    const double duration_s = 1e-9 * static_cast<double>(truth_.back().stamp_ns - stamp_ns(0, lidar));
    return duration_s < 0.0 ? 0 : static_cast<std::size_t>(duration_s * settings_.lidar.rate_hz) + 1;
}

Trajectory Simulation::truth_at_scans() const {
    Trajectory truth;
    for (std::size_t index = 0; index < frame_count(); ++index) {
        const std::int64_t stamp = stamp_ns(index);
        truth.push_back({stamp, *pose_at(truth_, stamp)});
    }
    return truth;
}

SimulatedFrame Simulation::frame(std::size_t index, std::size_t lidar) const {
    LaserScan scan = blank_scan(settings_.lidar, stamp_ns(index, lidar));
    const Pose2& robot_from_laser = this->robot_from_laser(lidar);
    const Pose2 robot = *pose_at(truth_, scan.stamp_ns);
    const std::vector<Pose2> still{robot * robot_from_laser};
    const BeamHits still_hits = cast_beams(scan, still, caster_);
    const std::vector<Pose2> lasers = settings_.lidar.motion_distortion ? laser_poses(scan, robot_from_laser) : still;
    const BeamHits hits = settings_.lidar.motion_distortion ? cast_beams(scan, lasers, caster_) : still_hits;
    SimulatedFrame result;
    result.fisher_information = fisher_information(scan, still_hits, robot, robot_from_laser, settings_.lidar);
    const RandomStream noise = lidar == 0 ? RandomStream({settings_.seed, scan_noise, index})
                                          : RandomStream({settings_.seed, scan_noise, index, lidar});
    scan.ranges_m = measure_ranges(scan, lasers, hits, caster_, settings_.lidar, noise);
    normalise_ranges(scan);
    const auto odometry_after = [&](double seconds) {
        const std::int64_t then_ns = stamp_ns(index, lidar) + std::llround(1e9 * seconds);
        return pose_at(odometry_, std::min(then_ns, odometry_.back().stamp_ns));
    };
    std::vector<Pose2> sweep = sweep_of(scan, scan.time_increment_s, odometry_after);
    SensorFrame& frame = result.frame;
    frame.scan = std::move(scan);
    frame.robot_from_laser = robot_from_laser;
    frame.odom_from_robot = *pose_at(odometry_, stamp_ns(index, lidar));
    frame.world_from_robot = robot;
    frame.sweep = std::move(sweep);
    frame.lidar = lidar;
    return result;
}

std::int64_t Simulation::stamp_ns(std::size_t index, std::size_t lidar) const {
    const double turns = static_cast<double>(index) + static_cast<double>(lidar) / static_cast<double>(lidar_count());
    const double seconds = turns / settings_.lidar.rate_hz;
    return settings_.start_ns + static_cast<std::int64_t>(std::floor(1e9 * seconds));
}

std::vector<Pose2> Simulation::laser_poses(const LaserScan& scan, const Pose2& robot_from_laser) const {
    std::vector<Pose2> poses;
    for (std::size_t beam = 0; beam < scan.ranges_m.size(); ++beam) {
        const double later_s = static_cast<double>(beam) * scan.time_increment_s;
        const std::int64_t stamp_ns = scan.stamp_ns + static_cast<std::int64_t>(1e9 * later_s);
        poses.push_back(pose_at(truth_, stamp_ns).value_or(truth_.back().pose) * robot_from_laser);
    }
    return poses;
}

}  // namespace ddtool::sim

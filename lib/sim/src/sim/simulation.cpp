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
      odometry_(simulate_odometry(truth_, settings.odometry, settings.seed)) {
    const double duration_s = 1e-9 * static_cast<double>(truth_.back().stamp_ns - truth_.front().stamp_ns);
    frame_count_ = static_cast<std::size_t>(duration_s * settings.lidar.rate_hz) + 1;
}

SimulatedFrame Simulation::frame(std::size_t index) const {
    LaserScan scan = blank_scan(settings_.lidar, stamp_ns(index));
    const Pose2 robot = *pose_at(truth_, scan.stamp_ns);
    const std::vector<Pose2> still{robot * settings_.robot_from_laser};
    const BeamHits still_hits = cast_beams(scan, still, caster_);
    const std::vector<Pose2> lasers = settings_.lidar.motion_distortion ? laser_poses(scan) : still;
    const BeamHits hits = settings_.lidar.motion_distortion ? cast_beams(scan, lasers, caster_) : still_hits;
    SimulatedFrame result;
    result.fisher_information =
        fisher_information(scan, still_hits, robot, settings_.robot_from_laser, settings_.lidar);
    scan.ranges_m =
        measure_ranges(scan, lasers, hits, caster_, settings_.lidar, RandomStream({settings_.seed, scan_noise, index}));
    normalise_ranges(scan);
    const auto odometry_after = [&](double seconds) {
        const std::int64_t then_ns = stamp_ns(index) + std::llround(1e9 * seconds);
        return pose_at(odometry_, std::min(then_ns, odometry_.back().stamp_ns));
    };
    std::vector<Pose2> sweep = sweep_of(scan, scan.time_increment_s, odometry_after);
    result.frame = {std::move(scan), settings_.robot_from_laser, *pose_at(odometry_, stamp_ns(index)), robot,
                    std::move(sweep)};
    return result;
}

std::int64_t Simulation::stamp_ns(std::size_t index) const {
    const double seconds = static_cast<double>(index) / settings_.lidar.rate_hz;
    return settings_.start_ns + static_cast<std::int64_t>(std::floor(1e9 * seconds));
}

std::vector<Pose2> Simulation::laser_poses(const LaserScan& scan) const {
    std::vector<Pose2> poses;
    for (std::size_t beam = 0; beam < scan.ranges_m.size(); ++beam) {
        const double later_s = static_cast<double>(beam) * scan.time_increment_s;
        const std::int64_t stamp_ns = scan.stamp_ns + static_cast<std::int64_t>(1e9 * later_s);
        poses.push_back(pose_at(truth_, stamp_ns).value_or(truth_.back().pose) * settings_.robot_from_laser);
    }
    return poses;
}

}  // namespace ddtool::sim

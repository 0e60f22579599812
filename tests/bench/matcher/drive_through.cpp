#include "drive_through.hpp"

#include <cmath>
#include <utility>

#include "sim/drive.hpp"
#include "sim/fisher_information.hpp"
#include "sim/random_purpose.hpp"

namespace ddtool::matcher_bench {
namespace {

constexpr std::int64_t drive_step_ns = 10'000'000;

bool update_due(const Pose2& motion, const RbpfSettings& filter) {
    return std::hypot(motion.x_m, motion.y_m) >= filter.update_distance_m ||
           std::abs(motion.theta_rad) >= filter.update_turn_rad;
}

Place place_at(const StampedPose& robot, double way_m, const sim::RayCaster& caster, const sim::LidarSettings& lidar,
               const RandomStream& noise) {
    LaserScan scan = sim::blank_scan(lidar, robot.stamp_ns);
    const std::vector<Pose2> laser{robot.pose};
    const sim::BeamHits hits = sim::cast_beams(scan, laser, caster);
    Place place;
    place.way_m = way_m;
    place.information = sim::fisher_information(scan, hits, robot.pose, {}, lidar);
    scan.ranges_m = sim::measure_ranges(scan, laser, hits, caster, lidar, noise);
    normalise_ranges(scan);
    place.frame.scan = std::move(scan);
    place.frame.odom_from_robot = robot.pose;
    place.frame.world_from_robot = robot.pose;
    return place;
}

}  // namespace

std::vector<Place> drive_through(const BenchWorld& world, const sim::LidarSettings& lidar, const RbpfSettings& filter,
                                 std::uint64_t seed) {
    const sim::RayCaster caster(world.world);
    std::vector<Place> places;
    for (const StampedPose& robot : sim::drive(world.world.route, {}, 0, drive_step_ns)) {
        if (!places.empty() && !update_due(between(places.back().pose(), robot.pose), filter)) {
            continue;
        }
        const double way_m = places.empty() ? 0.0 : places.back().way_m + distance_m(places.back().pose(), robot.pose);
        const RandomStream noise({seed, sim::scan_noise, places.size()});
        places.push_back(place_at(robot, way_m, caster, lidar, noise));
        places.back().along_rad = world.along_rad.value_or(robot.pose.theta_rad);
    }
    return places;
}

}  // namespace ddtool::matcher_bench

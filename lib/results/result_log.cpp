#include "results/result_log.hpp"

#include <algorithm>
#include <array>

#include "logs/ros_conversions.hpp"

namespace ddtool {
namespace {

constexpr const char* map_frame = "map";
constexpr const char* odom_frame = "odom";
constexpr const char* robot_frame = "base_link";
constexpr const char* laser_frame = "laser";

/// Maps are written when the run has become a tenth longer, but not more often than this.
constexpr std::int64_t least_map_interval_ns = 10'000'000'000;
constexpr std::int64_t map_interval_share = 10;

/// Poses of the path nearer than this to the one before say nothing in a picture.
constexpr double path_step_m = 0.1;

/// The poses that show the way: path_step_m apart, and the last.
Trajectory thinned(const Trajectory& path) {
    Trajectory kept;
    for (const StampedPose& pose : path) {
        if (kept.empty() || distance_m(kept.back().pose, pose.pose) >= path_step_m) {
            kept.push_back(pose);
        }
    }
    if (!kept.empty() && kept.back().stamp_ns != path.back().stamp_ns) {
        kept.push_back(path.back());
    }
    return kept;
}

}  // namespace

void ResultLog::add(const SensorFrame& frame, const Rbpf& filter) {
    const std::int64_t stamp_ns = frame.scan.stamp_ns;
    write_transforms(frame, filter.pose());
    file_.write("/scan", stamp_ns, ros::to_message(frame.scan, laser_frame));
    write_particles(stamp_ns, filter.particles());
    if (start_ns_) {  // the first scan only starts the map
        write_report(filter.last_report());
    }
    if (map_is_due(stamp_ns)) {
        write_map(stamp_ns, map_raster(filter.best().grid));
        write_path(stamp_ns, filter.trajectory());
        map_written_ns_ = stamp_ns;
    }
    start_ns_ = start_ns_.value_or(stamp_ns);
}

void ResultLog::finish(const MapRaster& map, const Trajectory& path) {
    const std::int64_t stamp_ns = path.empty() ? 0 : path.back().stamp_ns;
    write_map(stamp_ns, map);
    write_path(stamp_ns, path);
}

/// So the file holds a few dozen maps, however long the run.
bool ResultLog::map_is_due(std::int64_t stamp_ns) const {
    if (!start_ns_) {
        return true;
    }
    const std::int64_t interval_ns =
        std::max(least_map_interval_ns, (map_written_ns_ - *start_ns_) / map_interval_share);
    return stamp_ns - map_written_ns_ >= interval_ns;
}

void ResultLog::write_transforms(const SensorFrame& frame, const Pose2& map_from_robot) {
    const std::int64_t stamp_ns = frame.scan.stamp_ns;
    if (robot_from_laser_ != frame.robot_from_laser) {
        robot_from_laser_ = frame.robot_from_laser;
        file_.write("/tf_static", stamp_ns,
                    ros::transform_message(stamp_ns, robot_frame, laser_frame, frame.robot_from_laser));
    }
    const Pose2 map_from_odom = map_from_robot * inverse(frame.odom_from_robot);
    file_.write("/tf", stamp_ns, ros::transform_message(stamp_ns, map_frame, odom_frame, map_from_odom));
    file_.write("/tf", stamp_ns, ros::transform_message(stamp_ns, odom_frame, robot_frame, frame.odom_from_robot));
}

void ResultLog::write_particles(std::int64_t stamp_ns, std::span<const Particle> particles) {
    ros::PoseArray cloud{.header = {{stamp_ns}, map_frame}, .poses = {}};
    for (const Particle& particle : particles) {
        cloud.poses.push_back(ros::to_pose(particle.pose));
    }
    file_.write("/particlecloud", stamp_ns, cloud);
}

void ResultLog::write_report(const UpdateReport& report) {
    file_.write("/degeneracy", report.stamp_ns,
                ros::Degeneracy{{report.stamp_ns},
                                report.degeneracy.degree,
                                report.dispersion,
                                report.swarm.major_variance_m2,
                                report.swarm.minor_variance_m2,
                                report.swarm.major_direction_rad,
                                report.corrected_m,
                                report.resampled ? 1U : 0U});
}

void ResultLog::add_pose(std::int64_t stamp_ns, const Rbpf& filter) {
    const Eigen::Matrix3d covariance = filter.pose_covariance();
    ros::PoseWithCovarianceStamped pose{
        .header = {{stamp_ns}, map_frame}, .pose = ros::to_pose(filter.pose()), .covariance = {}};
    constexpr std::array<std::size_t, 3> places{0, 1, 5};  // x, y and the turn about z among six
    for (std::size_t row = 0; row < 3; ++row) {
        for (std::size_t column = 0; column < 3; ++column) {
            pose.covariance[6 * places[row] + places[column]] =
                covariance(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(column));
        }
    }
    file_.write("/pose", stamp_ns, pose);
}

void ResultLog::write_map(std::int64_t stamp_ns, const MapRaster& map) {
    ros::OccupancyGrid message{.header = {{stamp_ns}, map_frame},
                               .map_load_time = {stamp_ns},
                               .resolution = static_cast<float>(map.cell_size_m),
                               .width = static_cast<std::uint32_t>(map.width),
                               .height = static_cast<std::uint32_t>(map.height),
                               .origin = ros::to_pose({map.origin_m.x_m, map.origin_m.y_m, 0.0}),
                               .data = map.cells};
    file_.write("/map", stamp_ns, message);
}

void ResultLog::write_path(std::int64_t stamp_ns, const Trajectory& path) {
    ros::Path message{.header = {{stamp_ns}, map_frame}, .poses = {}};
    for (const StampedPose& pose : thinned(path)) {
        message.poses.push_back(ros::pose_message(pose.stamp_ns, map_frame, pose.pose));
    }
    file_.write("/path", stamp_ns, message);
}

}  // namespace ddtool

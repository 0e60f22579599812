#include "run/run_messages.hpp"

#include <algorithm>
#include <array>

#include "logs/messages/ros_conversions.hpp"

namespace ddtool {
namespace {

constexpr const char* map_frame = "map";
constexpr const char* odom_frame = "odom";
constexpr const char* robot_frame = "base_link";
constexpr const char* laser_frame = "laser";

/// The path is thinned to poses at least this far apart, since closer ones cannot be told apart in a picture, and to at
/// most about this many poses.
constexpr double path_step_m = 0.1;
constexpr double most_path_poses = 65'536.0;

/// The poses of the path that are one step apart, and the last pose.
Trajectory thinned(const Trajectory& path) {
    const double step_m = std::max(path_step_m, path_length_m(path) / most_path_poses);
    Trajectory kept;
    for (const StampedPose& pose : path) {
        if (kept.empty() || distance_m(kept.back().pose, pose.pose) >= step_m) {
            kept.push_back(pose);
        }
    }
    if (!kept.empty() && kept.back().stamp_ns != path.back().stamp_ns) {
        kept.push_back(path.back());
    }
    return kept;
}

}  // namespace

void RunMessages::add(const SensorFrame& frame, const Update& update) {
    if (reader_ == Reader::viewer) {
        write_transforms(frame, update.pose);
        sink_.write("/scan", frame.scan.stamp_ns, scan_message(frame.scan, laser_frame));
    }
    write_particles(update.corrected);
    write_degeneracy(summary_of(update));
}

void RunMessages::write_transforms(const SensorFrame& frame, const Pose2& map_from_robot) {
    const std::int64_t stamp_ns = frame.scan.stamp_ns;
    if (robot_from_laser_ != frame.robot_from_laser) {
        robot_from_laser_ = frame.robot_from_laser;
        sink_.write("/tf_static", stamp_ns,
                    transform_message(stamp_ns, robot_frame, laser_frame, frame.robot_from_laser));
    }
    const Pose2 map_from_odom = map_from_robot * inverse(frame.odom_from_robot);
    // Both transforms go into one message, so that a client that gets only the latest message of the topic still has
    // the whole chain from the map to the robot.
    RosTFMessage way = transform_message(stamp_ns, map_frame, odom_frame, map_from_odom);
    way.transforms.push_back(
        transform_message(stamp_ns, odom_frame, robot_frame, frame.odom_from_robot).transforms.front());
    sink_.write("/tf", stamp_ns, way);
}

void RunMessages::write_particles(const ParticleSnapshot& swarm) {
    RosPoseArray cloud{.header = {{swarm.stamp_ns}, map_frame}, .poses = {}};
    for (const SnapshotParticle& particle : swarm.particles) {
        cloud.poses.push_back(to_ros_pose(particle.pose));
    }
    sink_.write("/particlecloud", swarm.stamp_ns, cloud);
}

void RunMessages::write_degeneracy(const UpdateSummary& update) {
    sink_.write("/degeneracy", update.stamp_ns,
                RosDegeneracy{{update.stamp_ns},
                              update.degree,
                              update.dispersion,
                              update.swarm.major_variance_m2,
                              update.swarm.minor_variance_m2,
                              update.swarm.major_direction_rad,
                              update.corrected_m,
                              update.resampled ? 1U : 0U});
}

void RunMessages::add_pose(std::int64_t stamp_ns, const ParticleFilter& filter) {
    const Eigen::Matrix3d covariance = filter.pose_covariance();
    RosPoseWithCovarianceStamped pose{
        .header = {{stamp_ns}, map_frame}, .pose = to_ros_pose(filter.pose()), .covariance = {}};
    // x, y and the rotation about z among the six axes of a ROS pose
    constexpr std::array<std::size_t, 3> places{0, 1, 5};
    for (std::size_t row = 0; row < 3; ++row) {
        for (std::size_t column = 0; column < 3; ++column) {
            pose.covariance[6 * places[row] + places[column]] =
                covariance(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(column));
        }
    }
    sink_.write("/pose", stamp_ns, pose);
}

void RunMessages::add_map(std::int64_t stamp_ns, const MapRaster& map) {
    RosOccupancyGrid message{.header = {{stamp_ns}, map_frame},
                             .map_load_time = {stamp_ns},
                             .resolution = static_cast<float>(map.cell_size_m),
                             .width = static_cast<std::uint32_t>(map.width),
                             .height = static_cast<std::uint32_t>(map.height),
                             .origin = to_ros_pose({map.origin_m.x_m, map.origin_m.y_m, 0.0}),
                             .data = map.cells};
    sink_.write("/map", stamp_ns, message);
}

void RunMessages::add_path(std::int64_t stamp_ns, const Trajectory& path) {
    RosPath message{.header = {{stamp_ns}, map_frame}, .poses = {}};
    for (const StampedPose& pose : thinned(path)) {
        message.poses.push_back(pose_message(pose.stamp_ns, map_frame, pose.pose));
    }
    sink_.write("/path", stamp_ns, message);
}

}  // namespace ddtool

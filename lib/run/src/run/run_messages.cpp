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
/// most about this many poses. A screen is not wider in pixels, and a robot sends the path once per second.
constexpr double path_step_m = 0.1;
constexpr double most_path_poses = 8192.0;

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

void RunMessages::add_path(std::int64_t stamp_ns, const ParticleFilter& filter) {
    write_path(stamp_ns, [&](const PoseVisitor& visit) { filter.visit_trajectory(visit); });
}

void RunMessages::add_path(std::int64_t stamp_ns, const Trajectory& path) {
    write_path(stamp_ns, [&](const PoseVisitor& visit) { std::ranges::for_each(path, visit); });
}

void RunMessages::write_path(std::int64_t stamp_ns, const std::function<void(const PoseVisitor&)>& path) {
    double length_m = 0.0;
    std::optional<StampedPose> last;
    path([&](const StampedPose& pose) {
        length_m += last ? distance_m(last->pose, pose.pose) : 0.0;
        last = pose;
    });
    const double step_m = std::max(path_step_m, length_m / most_path_poses);
    RosPath message{.header = {{stamp_ns}, map_frame}, .poses = {}};
    std::optional<StampedPose> kept;
    const auto keep = [&](const StampedPose& pose) {
        message.poses.push_back(pose_message(pose.stamp_ns, map_frame, pose.pose));
        kept = pose;
    };
    path([&](const StampedPose& pose) {
        if (!kept || distance_m(kept->pose, pose.pose) >= step_m) {
            keep(pose);
        }
    });
    if (kept && kept->stamp_ns != last->stamp_ns) {
        keep(*last);
    }
    sink_.write("/path", stamp_ns, message);
}

}  // namespace ddtool

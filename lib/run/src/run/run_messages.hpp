#pragma once

#include <cstdint>
#include <optional>

#include "ddtool/filter/rbpf.hpp"
#include "ddtool/robot/sensor_stream.hpp"
#include "ddtool/robot/trajectory.hpp"
#include "logs/messages/ros2_sink.hpp"
#include "report/map_raster.hpp"
#include "run/run_course.hpp"

namespace ddtool {

/// What a run tells Foxglove and RViz, as ROS 2 messages (docs/formats/results.md): the scans the filter used, its
/// particles and its degree, the transforms map -> odom -> base_link -> laser, and the map and the path when asked.
class RunMessages {
public:
    explicit RunMessages(Ros2Sink& sink) : sink_(sink) {}

    /// What an update of the filter, made from the frame, gave.
    void add(const SensorFrame& frame, const Update& update);
    /// Where the robot is after the filter has taken a frame, whether or not that was an update.
    void add_pose(std::int64_t stamp_ns, const Rbpf& filter);
    /// The map and the path as they are now.
    void add_map(std::int64_t stamp_ns, const MapRaster& map, const Trajectory& path);

private:
    void write_transforms(const SensorFrame& frame, const Pose2& map_from_robot);
    void write_degeneracy(const UpdateSummary& update);
    void write_particles(const ParticleSnapshot& swarm);
    void write_map(std::int64_t stamp_ns, const MapRaster& map);
    void write_path(std::int64_t stamp_ns, const Trajectory& path);

    Ros2Sink& sink_;
    std::optional<Pose2> robot_from_laser_;  ///< as last written
};

}  // namespace ddtool

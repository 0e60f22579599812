#pragma once

#include <cstdint>
#include <functional>
#include <optional>

#include "ddtool/filter/particle_filter.hpp"
#include "ddtool/robot/sensor_stream.hpp"
#include "ddtool/robot/trajectory.hpp"
#include "logs/messages/ros2_sink.hpp"
#include "report/map_raster.hpp"
#include "run/run_course.hpp"

namespace ddtool {

/// Publishes a run as ROS 2 messages for Foxglove and RViz (docs/formats/results.md): the scans that the filter used,
/// its particles and its degree of degeneracy, the transforms map -> odom -> base_link -> laser, and, on request, the
/// map and the path.
///
/// A robot that is driving has its own scans and transforms, so that it gets neither.
class RunMessages {
public:
    enum class Reader { viewer, robot };

    explicit RunMessages(Ros2Sink& sink, Reader reader = Reader::viewer) : sink_(sink), reader_(reader) {}

    /// Publishes the result of the filter update that the frame caused.
    void add(const SensorFrame& frame, const Update& update);
    /// Publishes where the robot is after the filter has processed a frame, whether or not the frame caused an update.
    void add_pose(std::int64_t stamp_ns, const ParticleFilter& filter);
    /// Publishes the map as it is now.
    void add_map(std::int64_t stamp_ns, const MapRaster& map);
    /// Publishes the path as it is now.
    void add_path(std::int64_t stamp_ns, const ParticleFilter& filter);
    /// Publishes the path of the end of the run.
    void add_path(std::int64_t stamp_ns, const Trajectory& path);

private:
    void write_transforms(const SensorFrame& frame, const Pose2& map_from_robot);
    void write_degeneracy(const UpdateSummary& update);
    void write_particles(const ParticleSnapshot& swarm);
    /// `path` calls its argument with one pose after the other, each time it is called.
    void write_path(std::int64_t stamp_ns, const std::function<void(const PoseVisitor&)>& path);

    Ros2Sink& sink_;
    Reader reader_;
    std::optional<Pose2> robot_from_laser_;  ///< as last written
};

}  // namespace ddtool

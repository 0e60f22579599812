#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>

#include "geometry/trajectory.hpp"
#include "logs/ros2_writer.hpp"
#include "results/map_raster.hpp"
#include "sensor/sensor_stream.hpp"
#include "slam/rbpf.hpp"

namespace ddtool {

/// A run for Foxglove and RViz, as ROS 2 messages in an MCAP file (docs/formats/results.md): the scans the filter used,
/// its particles, the transforms map -> odom -> base_link -> laser, and now and then the map and the path.
class ResultLog {
public:
    explicit ResultLog(const std::filesystem::path& path) : file_(path) {}

    /// After the frame has moved the filter.
    void add(const SensorFrame& frame, const Rbpf& filter);
    /// After the filter has taken any frame.
    void add_pose(std::int64_t stamp_ns, const Rbpf& filter);
    /// The map and the path as they are at the end.
    void finish(const MapRaster& map, const Trajectory& path);
    /// Completes the file; without it nothing is left behind.
    void close() { file_.close(); }

private:
    void write_transforms(const SensorFrame& frame, const Pose2& map_from_robot);
    void write_report(const UpdateReport& report);
    void write_particles(std::int64_t stamp_ns, std::span<const Particle> particles);
    void write_map(std::int64_t stamp_ns, const MapRaster& map);
    void write_path(std::int64_t stamp_ns, const Trajectory& path);
    [[nodiscard]] bool map_is_due(std::int64_t stamp_ns) const;

    Ros2Writer file_;
    std::optional<Pose2> robot_from_laser_;  ///< as last written
    std::optional<std::int64_t> start_ns_;
    std::int64_t map_written_ns_ = 0;
};

}  // namespace ddtool

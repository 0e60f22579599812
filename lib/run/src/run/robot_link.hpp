#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "ddtool/filter/particle_filter.hpp"
#include "ddtool/logs/log_stream.hpp"
#include "ddtool/system/settings.hpp"
#include "localization/localizer.hpp"
#include "report/map_raster.hpp"

namespace ddtool {

/// A robot that is driving now: its scans and odometry come from it, and the poses and the map go to it. For one thread
/// at a time, that of the filter.
class RobotLink {
public:
    RobotLink() = default;
    virtual ~RobotLink() = default;
    RobotLink(const RobotLink&) = delete;
    RobotLink& operator=(const RobotLink&) = delete;

    /// How the robot is called in messages, where a log has the name of its file.
    [[nodiscard]] virtual std::string name() const = 0;
    /// Waits for the robot, and then gives its scans until `stop` returns true. Call this once. The link must outlive
    /// the stream. Throws Error if `stop` returns true before the first scan, and UsageError as open_log() does.
    virtual std::unique_ptr<LogStream> scans(const LogOptions& options, std::function<bool()> stop,
                                             LogProblemHandler on_problem) = 0;
    /// Gives the map in which the robot is to be found, and which stays as it is. Call this before scans(), if at all.
    virtual void show_fixed_map(const MapRaster& map) = 0;
    /// The place in the map that the robot's people have told since the last call, if they have.
    virtual std::optional<localization::StartPose> take_initial_pose() = 0;
    /// Call this after the filter has processed the frame. `update` is empty where the frame caused no update.
    /// \param standing what is known about being in the right place; null where the map begins with the run
    virtual void add(const SensorFrame& frame, const std::optional<Update>& update, const ParticleFilter& filter,
                     const localization::Standing* standing) = 0;
    /// Gives the map, unless it is fixed, and the path as they are at the end of the run.
    virtual void finish(const MapRaster& map, const Trajectory& path) = 0;

    /// What happened, for run.json.
    [[nodiscard]] virtual Json report() const = 0;
    /// Why the result may suffer, one line each.
    [[nodiscard]] virtual std::vector<std::string> losses() const = 0;
};

}  // namespace ddtool

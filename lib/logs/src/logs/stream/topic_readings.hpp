#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "ddtool/logs/log_problem.hpp"
#include "ddtool/robot/trajectory.hpp"
#include "logs/messages/readings.hpp"

namespace ddtool {

/// Which transforms of a topic are read; an empty name fits every frame.
struct TransformNames {
    std::string frame;
    std::string child_frame;
};

/// The poses of a topic of odometry, poses, velocities or transforms as they were recorded, in the order of the log:
/// x, y and yaw of frame_from_child. Velocities are integrated (PoseReader).
/// \param names for transforms, and other poses that name a child frame
/// \param on_progress is called with the share read, 0..1, and may throw
/// Throws UsageError if the log has no such poses there, and Error as open_messages() does, also for a CARMEN log.
Trajectory read_poses(const std::filesystem::path& log, const std::string& topic, const TransformNames& names,
                      LogProblemHandler on_problem, const std::function<void(double)>& on_progress);

/// The readings of a topic of an inertial sensor, likewise; of the first such topic in the log where none is named.
std::vector<ImuReading> read_imu(const std::filesystem::path& log, const std::string& topic,
                                 LogProblemHandler on_problem, const std::function<void(double)>& on_progress);

}  // namespace ddtool

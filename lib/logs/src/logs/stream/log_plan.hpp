#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "logs/stream/laser_mounting.hpp"
#include "logs/stream/log_survey.hpp"

namespace ddtool {

/// Which messages of a log are used, and how.
struct LogPlan {
    std::string scan_topic;
    std::string odom_topic;  ///< empty: the log has no odometry
    std::string ground_truth_topic;
    bool has_information = false;  ///< the log has the Fisher information of every scan, from the simulator
    /// If the odometry comes from transforms: the frames between which the transform is taken.
    std::string odom_frame;
    std::string robot_frame;
    StampRule scan_stamps;
    StampRule odom_stamps;
    StampRule ground_truth_stamps;
    /// What is added to the stamps of the odometry, because its clock is not that of the scans.
    std::int64_t odom_clock_offset_ns = 0;
    /// Where the lasers are on the robot, by the frame of their scans.
    std::map<std::string, Eigen::Isometry3d> robot_from_laser;
    /// For scans in frames without an entry there; empty: such scans cannot be used.
    std::optional<Eigen::Isometry3d> robot_from_other_laser;
    RangeRules ranges;
    std::vector<std::string> assumptions;
    std::vector<std::string> faults;  ///< what cannot be believed in the log, one line each
};

/// Chooses topics by type, then by name; topics that the options name take precedence. Of several robots, those of the
/// robot whose scans are used come first.
/// \param file the name of the log, for messages
/// Throws UsageError for a topic that is not in the log, naming the suitable ones, and Error if there are no scans,
/// naming what there is.
LogPlan plan_log(const LogSurvey& survey, const LogOptions& options, const std::string& file);

}  // namespace ddtool

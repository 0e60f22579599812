#pragma once

#include <Eigen/Geometry>
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
    Eigen::Isometry3d robot_from_laser = Eigen::Isometry3d::Identity();
    RangeRules ranges;
    std::vector<std::string> assumptions;
};

/// Chooses topics by type, then by name; topics that the options name take precedence.
/// \param file the name of the log, for messages
/// Throws UsageError for a topic that is not in the log, naming the suitable ones, and Error if there are no scans,
/// naming what there is.
LogPlan plan_log(const LogSurvey& survey, const LogOptions& options, const std::string& file);

}  // namespace ddtool

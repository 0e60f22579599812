#pragma once

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "logs/stream/log_survey.hpp"

namespace ddtool {

/// Which messages of a log are used, and how.
struct LogPlan {
    std::string scan_topic;
    std::string odom_topic;  ///< empty: there is none
    std::string ground_truth_topic;
    bool has_information = false;  ///< the simulator's, of every scan
    /// Where odometry comes from transforms: the frames whose transform it is.
    std::string odom_frame;
    std::string robot_frame;
    Eigen::Isometry3d robot_from_laser = Eigen::Isometry3d::Identity();
    std::vector<std::string> assumptions;
};

/// Chooses by type, then by name; what the options name wins. `file` is for messages. Throws UsageError for a topic
/// that is not there, naming those that would do, and Error when there are no scans, naming what there is.
LogPlan plan_log(const LogSurvey& survey, const LogOptions& options, const std::string& file);

}  // namespace ddtool

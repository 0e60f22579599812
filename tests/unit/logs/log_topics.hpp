#pragma once

#include <optional>
#include <string>
#include <utility>

#include "ddtool/logs/log_stream.hpp"

namespace ddtool::test {

/// Options that name the topics of a log, and the pose of its laser.
inline LogOptions topics(std::string scan, std::string odom = "", std::string ground_truth = "",
                         const std::optional<Pose2>& laser_pose = std::nullopt) {
    LogOptions options;
    options.scan_topic = std::move(scan);
    options.odom_topic = std::move(odom);
    options.ground_truth_topic = std::move(ground_truth);
    options.laser_pose = laser_pose;
    return options;
}

}  // namespace ddtool::test

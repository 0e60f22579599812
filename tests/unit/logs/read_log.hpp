#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "ddtool/base/error.hpp"
#include "ddtool/logs/log_stream.hpp"

namespace ddtool::test {

/// Everything that results from reading a log.
struct ReadLog {
    std::vector<SensorFrame> frames;
    std::vector<std::string> problems;
    LogSummary summary;
    std::string error;  ///< the error that ended the reading; empty if the log was read to its end
};

/// Reads all frames. `open` makes the stream with the problem handler that it is given.
inline ReadLog read_all(const std::function<std::unique_ptr<LogStream>(LogProblemHandler)>& open) {
    ReadLog result;
    try {
        const auto log = open([&](const LogProblem& problem) { result.problems.push_back(problem.what); });
        while (auto frame = log->next()) {
            result.frames.push_back(std::move(*frame));
        }
        result.summary = log->summary();
    } catch (const Error& error) {
        result.error = error.what();
    }
    return result;
}

inline ReadLog read_all(const std::filesystem::path& path) {
    return read_all([&](const LogProblemHandler& on_problem) { return open_log(path, {}, on_problem); });
}

/// Whether the frames are equal, bit by bit.
inline bool same(const SensorFrame& a, const SensorFrame& b) {
    const auto same_pose = [](const Pose2& p, const Pose2& q) {
        return p.x_m == q.x_m && p.y_m == q.y_m && p.theta_rad == q.theta_rad;
    };
    return a.scan.stamp_ns == b.scan.stamp_ns && a.scan.angle_min_rad == b.scan.angle_min_rad &&
           a.scan.angle_increment_rad == b.scan.angle_increment_rad && a.scan.range_max_m == b.scan.range_max_m &&
           a.scan.ranges_m == b.scan.ranges_m && same_pose(a.robot_from_laser, b.robot_from_laser) &&
           same_pose(a.odom_from_robot, b.odom_from_robot);
}

/// Whether `start` consists of the first frames of `whole`.
inline bool begins_with(const std::vector<SensorFrame>& whole, const std::vector<SensorFrame>& start) {
    return start.size() <= whole.size() && std::equal(start.begin(), start.end(), whole.begin(), same);
}

}  // namespace ddtool::test

#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "ddtool/logs/log_problem.hpp"
#include "ddtool/robot/pose2.hpp"
#include "ddtool/robot/sensor_stream.hpp"

namespace ddtool {

/// Which of a log's messages to use. What is not set is found by type (docs/formats/logs.md).
struct LogOptions {
    std::string scan_topic;           ///< in a CARMEN log the message name, FLASER or ROBOTLASER1
    std::string odom_topic;           ///< Odometry or tf messages
    std::string ground_truth_topic;   ///< Odometry or PoseStamped messages
    std::optional<Pose2> laser_pose;  ///< robot_from_laser, instead of the log's own
};

/// What was found in a log so far; complete once the stream has ended.
struct LogSummary {
    std::string format;
    std::string scan_topic;
    std::string odom_topic;                ///< empty: none
    bool has_odometry = true;              ///< known from the start; false: odom_from_robot is the identity
    std::string ground_truth_topic;        ///< empty: none
    std::size_t scans = 0;                 ///< frames given out
    std::size_t odometry = 0;              ///< odometry poses read
    std::size_t ground_truth = 0;          ///< ground truth poses read
    std::size_t problems = 0;              ///< things skipped or damaged: more than none means exit code 3
    std::uint64_t bytes_lost = 0;          ///< known to be unreadable
    std::vector<std::string> assumptions;  ///< what the log does not say and was taken as usual, a line each
};

/// The frames of a log, in the order of the file, in bounded memory.
class LogStream : public SensorStream {
public:
    explicit LogStream(LogProblemHandler on_problem);
    [[nodiscard]] const LogSummary& summary() const { return summary_; }

protected:
    void report(const LogProblem& problem);

    LogSummary summary_;

private:
    LogProblemHandler on_problem_;
};

/// Opens a log of any kind that is read (logs/log_container.hpp), told apart by content, not by name.
/// Throws Error naming the file for what is none of these or cannot be opened, UsageError for options that do not fit.
std::unique_ptr<LogStream> open_log(const std::filesystem::path& path, const LogOptions& options,
                                    LogProblemHandler on_problem);

}  // namespace ddtool

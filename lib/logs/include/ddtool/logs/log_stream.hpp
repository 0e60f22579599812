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

/// Heights in metres.
struct HeightBand {
    double min_m = 0.0;
    double max_m = 0.0;
};

/// Which messages of a log to use. What is not set is found by type (docs/formats/logs.md).
struct LogOptions {
    std::string robot;  ///< of several, the one with this name before its topics or frames
    /// In a CARMEN log the message name, FLASER or ROBOTLASER1. Several topics, separated by commas, are those of
    /// several lidars.
    std::string scan_topic;
    /// PointCloud2 messages, whose points within `height` become the scans; also several topics, and beside scans.
    std::string cloud_topic;
    std::optional<HeightBand> height;  ///< above the robot's origin; where not given, around the lidar
    std::size_t cloud_beams = 0;     ///< of the scans made from clouds, over a full turn; 0: as many as the cloud fills
    std::string odom_topic;          ///< Odometry or tf messages
    std::string ground_truth_topic;  ///< Odometry or PoseStamped messages
    /// Imu messages, whose turns are used where they are better than the odometry's; a topic named here is used in any
    /// case that makes sense, and "none" leaves them out.
    std::string imu_topic;
    std::optional<Pose2> laser_pose;  ///< robot_from_laser, instead of the log's own
    /// The readings that mean no return, in metres, instead of those that are found; 0 alone: there are none.
    std::vector<double> no_return_m;
    bool strongest_echo = false;  ///< of a beam with several echoes; false: the first
    double range_max_m = 0.0;     ///< instead of the log's own; 0: the log's own
    bool with_odometry = true;    ///< false: the log's odometry is left out
    /// Where the odometry of several publishers is interleaved, the number of the one to use, from 1 on in the order of
    /// their first poses; 0: the one that fits the scans best.
    std::size_t odom_path = 0;
    /// By how many seconds the odometry's stamps are later than those of the scans; empty: what the log shows.
    std::optional<double> odom_delay_s;
};

/// By how much the stamps of the odometry are later than those of the scans, measured by the turns of both.
struct OdometryDelay {
    double late_s = 0.0;
    double sigma_s = 0.0;  ///< standard deviation
};

/// What has been found in a log so far; it is complete when the stream has ended.
struct LogSummary {
    static constexpr std::size_t most_told = 5;

    std::string format;
    std::string scan_topic;                     ///< of the first lidar
    std::vector<std::string> more_scan_topics;  ///< of the other lidars that are used with it
    std::string odom_topic;                     ///< empty: the log has no odometry
    std::string odom_frame;                     ///< in which the odometry gives its poses; empty: it does not say so
    std::string robot_frame;                    ///< whose poses they are; empty: it does not say so
    bool has_odometry = true;                   ///< known from the start; false: odom_from_robot is the identity
    std::optional<OdometryDelay> odom_delay;    ///< empty: it could not be measured
    double odom_delay_removed_s = 0.0;          ///< what was taken off the odometry's stamps
    std::string imu_topic;                      ///< whose turns replace the odometry's; empty: none
    std::string ground_truth_topic;             ///< empty: the log has no ground truth
    std::size_t scans = 0;                      ///< frames returned by next()
    std::size_t odometry = 0;                   ///< odometry poses read
    std::size_t ground_truth = 0;               ///< ground truth poses read
    std::size_t problems = 0;                   ///< things skipped or damaged; if there are any, the exit code is 3
    std::uint64_t bytes_lost = 0;               ///< known to be unreadable
    std::vector<std::string> first_problems;    ///< LogProblem::what of the first of them, at most most_told
    std::vector<std::string> assumptions;       ///< what the log does not say and was assumed, one line each
};

/// The frames of a log, in the order of the file, in bounded memory. For one thread at a time.
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

/// Opens a log of any format that can be read (logs/log_container.hpp), recognised by content, not by name.
/// \param on_problem is called with each problem while the log is read, on the thread that reads it
/// Throws Error naming the file if it has none of these formats or cannot be opened, and UsageError for options that do
/// not fit the log.
std::unique_ptr<LogStream> open_log(const std::filesystem::path& path, const LogOptions& options,
                                    LogProblemHandler on_problem);

}  // namespace ddtool

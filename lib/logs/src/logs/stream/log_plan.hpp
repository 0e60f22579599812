#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "logs/stream/laser_mounting.hpp"
#include "logs/stream/log_survey.hpp"
#include "logs/stream/sweep_timer.hpp"
#include "logs/stream/turn_lag.hpp"

namespace ddtool {

/// A topic of scans, or of clouds that become scans.
struct LidarPlan {
    std::string topic;
    StampRule stamps;
    RangeRules ranges;
    SweepTiming sweep;
};

/// Which messages of a log are used, and how.
struct LogPlan {
    std::vector<LidarPlan> lidars;  ///< at least one; the first is the one whose frames others are joined to
    std::string odom_topic;         ///< empty: the log has no odometry
    std::string ground_truth_topic;
    std::string imu_topic;                                   ///< empty: none is used
    bool imu_is_named = false;                               ///< by the options
    Eigen::Vector3d imu_upwards = Eigen::Vector3d::UnitZ();  ///< the robot's z axis in the sensor's frame
    std::int64_t imu_clock_offset_ns = 0;                    ///< added to its stamps
    bool has_information = false;    ///< the log has the Fisher information of every scan, from the simulator
    std::string odom_frame;          ///< in which the odometry gives its poses
    std::string robot_frame;         ///< whose poses they are
    bool odom_is_transform = false;  ///< the odometry is the transform between these frames
    /// Which of the interleaved paths is used, as its InterleavedPaths::lineage(); empty: there is one path.
    std::vector<std::size_t> odom_lineage;
    StampRule odom_stamps;
    StampRule ground_truth_stamps;
    /// What is added to the stamps of the odometry, because its clock is not that of the scans.
    std::int64_t odom_clock_offset_ns = 0;
    std::optional<TurnLag> odom_lag;  ///< what is left after odom_clock_offset_ns, as the turns show it
    bool takes_off_lag = false;       ///< where it is significant; false where the options name a delay
    double odom_interval_s = 0.0;     ///< the usual time between two poses of the odometry; 0: unknown
    /// Where the lasers are on the robot, by the frame of their scans.
    std::map<std::string, Eigen::Isometry3d> robot_from_laser;
    /// For scans in frames without an entry there; empty: such scans cannot be used.
    std::optional<Eigen::Isometry3d> robot_from_other_laser;
    Echo echo = Echo::first;           ///< of beams with several
    std::optional<HeightBand> height;  ///< of the points of clouds, above the robot's origin, if asked for
    std::size_t cloud_beams = 0;       ///< as in LogOptions
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

#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "logs/stream/scan_rate.hpp"
#include "robot/sweep_trial.hpp"

namespace ddtool {

/// What may be the time in which a lidar measures one full turn, in seconds.
struct SweepTiming {
    /// 0: all beams are measured at once; negative: from the last beam to the first. The first is assumed.
    std::vector<double> turns_s{0.0};
    double view_rad = 0.0;  ///< of a scan, from its first beam to its last
    std::string doubt;      ///< one line if what the scans state cannot be true; otherwise empty
};

/// By what the scans state, if their beams fit between two scans. Otherwise, if they state a time, by the rate of the
/// scans; and if they state none, as simulators do whose scans are measured all at once, that is assumed. All of these
/// are candidates, and their reverse.
SweepTiming find_sweep_timing(const ScanRate& rate);

/// Says where the robot was when each beam of a scan was measured. The timing is the assumed one until the scans show
/// another one to be right (robot/sweep_trial.hpp). For one thread at a time.
class SweepTimer {
public:
    explicit SweepTimer(const SweepTiming& timing = {});

    /// The time from the stamp of a scan to the last of its beams, by the slowest candidate.
    [[nodiscard]] double longest_s(const LaserScan& scan) const;

    /// The time from the stamp of a scan to the middle of its beams, by the timing that the scans have shown so far.
    [[nodiscard]] double middle_s() const;

    /// Whether further scans cannot change the timing.
    [[nodiscard]] bool is_settled() const;
    /// Keeps the timing that the scans have shown so far.
    void settle();
    /// What the scans have shown; empty where it is what was assumed.
    [[nodiscard]] std::string finding() const;

    /// Sets the sweep of a frame, and the order and the time increment of its beams, which are then measured from the
    /// first to the last. Returns whether the timing changes with this scan.
    /// \param odom_from_robot the odometry's pose so many seconds after the stamp; nullopt where it is unknown
    bool apply(SensorFrame& frame, const std::function<std::optional<Pose2>(double)>& odom_from_robot);

private:
    std::vector<double> turns_s_;
    double view_rad_;
    SweepTrial trial_;
};

}  // namespace ddtool

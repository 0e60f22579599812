#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "ddtool/robot/sensor_stream.hpp"
#include "ddtool/robot/trajectory.hpp"
#include "logs/stream/stray_stamps.hpp"

namespace ddtool {

/// Compares the frames of a log with each other, before they are given out, and marks the steps of the odometry that
/// the scans refute.
///
/// Odometry is stuck where it stays within a millimetre and a milliradian while the scans pass three places, each of
/// which differs from the last one in half of its beams by more than 15 cm. A person or a door changes fewer beams, or
/// changes them once. While the odometry stands, frames therefore wait for what comes after them: up to
/// unchanged_waiting, and once a place is passed up to most_waiting.
///
/// Scans are missing where two are farther apart than two seconds and ten times their usual interval, and the odometry
/// says that the robot moved by more than a metre or a radian meanwhile, so that they may show different things.
///
/// Scans whose stamps are far from those of their neighbours (StrayStamps) are left out, counted, and named at the end.
class FrameWatch {
public:
    static constexpr std::size_t unchanged_waiting = 16;
    static constexpr std::size_t most_waiting = 64;

    FrameWatch() = default;
    /// \param most_held so many frames wait at most for what comes after them
    explicit FrameWatch(std::size_t most_held) : most_held_(most_held) {}

    void add(SensorFrame frame);
    /// There are no more frames: those that wait are ready.
    void end();
    /// The next frame that is ready.
    std::optional<SensorFrame> take();
    /// What was found since the last call, one line each, with no name of the log in front.
    std::vector<std::string> take_findings();

private:
    /// A view of one of the lasers while the odometry stands.
    struct Place {
        Pose2 robot_from_laser;
        std::vector<float> ranges_m;
        std::size_t passed = 0;  ///< places that the scans of this laser passed
    };

    void watch(SensorFrame frame);
    void stand(SensorFrame frame);
    void move(SensorFrame frame);
    void release_waiting();
    void end_stuck_part();
    void check_pause(const SensorFrame& frame);
    /// The median of the latest intervals; empty before the second scan.
    [[nodiscard]] std::optional<double> usual_interval_s() const;
    [[nodiscard]] std::size_t places_passed(const SensorFrame& frame);
    [[nodiscard]] std::string at(std::int64_t stamp_ns) const;

    std::size_t most_held_ = most_waiting;
    std::deque<SensorFrame> ready_;
    std::deque<SensorFrame> waiting_;       ///< while the odometry stands
    std::optional<StampedPose> before_;     ///< odom_from_robot at the last frame
    std::optional<std::int64_t> first_ns_;  ///< of the log
    StampedPose still_;                     ///< where and since when the odometry stands
    std::vector<Place> places_;             ///< the last ones since then
    std::size_t stuck_scans_ = 0;
    StrayStamps strays_;
    std::map<std::size_t, SensorFrame> suspects_;  ///< by lidar: scans that wait until it is known whether they stray
    std::deque<double> intervals_s_;               ///< between the latest scans
    std::vector<std::string> findings_;
};

}  // namespace ddtool

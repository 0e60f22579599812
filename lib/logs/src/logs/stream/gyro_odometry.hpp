#pragma once

#include <cstdint>
#include <deque>
#include <optional>

#include "ddtool/robot/trajectory.hpp"
#include "logs/stream/gyro_track.hpp"

namespace ddtool {

/// Odometry whose turns are a gyro's: distances come from the wheels, and turns from the gyro, less its bias. The bias
/// is followed while the wheels stand still. Where the gyro is silent, the wheels' turns are taken. Poses wait until
/// the gyro has reached them. For one thread at a time.
class GyroOdometry {
public:
    /// How long a pose waits for the gyro.
    static constexpr double longest_wait_s = 0.5;

    /// From now on the turns are the gyro's. Until then they are the odometry's own.
    /// \param scale, bias_rad_per_s GyroVerdict
    void use(double scale, double bias_rad_per_s);
    [[nodiscard]] bool is_used() const { return scale_.has_value(); }

    [[nodiscard]] const GyroTrack& gyro() const { return gyro_; }
    void add_rate(std::int64_t stamp_ns, double rate_rad_per_s) { gyro_.add(stamp_ns, rate_rad_per_s); }
    /// odom_from_robot by the odometry itself.
    void add_pose(const StampedPose& odom_from_robot) { waiting_.push_back(odom_from_robot); }
    /// The next pose that does not have to wait.
    /// \param at_end nothing more will be added, so that none has to
    std::optional<StampedPose> next(bool at_end);

private:
    [[nodiscard]] Pose2 corrected(const Pose2& motion, const StampedPose& before, const StampedPose& pose);

    GyroTrack gyro_;
    std::optional<double> scale_;
    double bias_rad_per_s_ = 0.0;
    double still_s_ = 0.0;  ///< time that the wheels stood still so far, as far as the bias remembers it
    std::deque<StampedPose> waiting_;
    std::optional<StampedPose> before_;  ///< as given
    Pose2 odom_from_robot_;
};

}  // namespace ddtool

#pragma once

#include <cstdint>
#include <deque>
#include <optional>

#include "ddtool/robot/sensor_stream.hpp"
#include "ddtool/robot/trajectory.hpp"

namespace ddtool {

/// The pieces of time in which odometry does not tell how the robot moved, and what of the motion from one moment to
/// another lies in them.
class OdometryGaps {
public:
    /// Odometry is missing where its messages are farther apart than this, and than five times their usual interval.
    static constexpr double least_gap_s = 0.5;

    struct Gap {
        std::int64_t from_ns = 0;
        std::int64_t to_ns = 0;
        OdometryStep step = OdometryStep::guessed;
    };

    /// \param usual_interval_s between two poses; 0 where it is not known
    explicit OdometryGaps(double usual_interval_s = 0.0);

    /// Notes the next pose. Returns the gap before it, if there is one: in a pause in which the robot moved, by more
    /// than 5 cm or 0.05 rad, the way between its ends is a guess.
    std::optional<Gap> add(const StampedPose& odom_from_robot);
    /// Notes that the motion between the last two poses is unknown.
    void add_unknown(std::int64_t from_ns, std::int64_t to_ns);
    /// What the odometry says of the motion between the two stamps, in whichever order.
    [[nodiscard]] OdometryStep step(std::int64_t a_ns, std::int64_t b_ns) const;

private:
    void keep(const Gap& gap);

    double least_s_;
    std::optional<StampedPose> before_;
    std::deque<Gap> gaps_;  ///< the latest
};

}  // namespace ddtool

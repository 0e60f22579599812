#pragma once

#include <cstddef>
#include <deque>
#include <optional>
#include <string>

#include "ddtool/robot/trajectory.hpp"

namespace ddtool {

/// Keeps odometry continuous where its source starts again at zero or jumps.
///
/// A step between two poses is a jump if it is longer than 0.3 m, faster than 1.5 m/s (3 m/s while no step was faster
/// than 0.3 m/s), three times longer than every step before and 2.5 times faster; the same for turns, from 0.25 rad and
/// 3 rad/s (6 rad/s while none was faster than 0.3 rad/s) on. A step longer than 0.3 m, and three times longer than
/// every step before, that ends exactly at the origin is a jump at any speed, because the source may have needed some
/// time to start again. The first twenty steps are taken as they are.
///
/// Across a jump that took no longer than longest_bridge_s the robot goes on as it moved before: of the scans' period
/// only a part is missing then, which a constant speed fills better than a match of two scans. Across a longer one it
/// stands still, and the motion has to be found elsewhere.
class OdometryResets {
public:
    static constexpr double longest_bridge_s = 0.1;

    struct Jump {
        double distance_m = 0.0;
        double turn_rad = 0.0;
        double duration_s = 0.0;
        bool to_origin = false;
        bool is_bridged = false;  ///< the motion across it is known: it went on as before
    };

    /// The next pose, with all jumps before it taken out.
    Pose2 follow(const StampedPose& odom_from_robot);
    /// Whether there was a jump before the last pose.
    [[nodiscard]] const std::optional<Jump>& last_jump() const { return last_jump_; }
    /// "jumps by 5.03 m and 40.0 deg in 0.05 s, to its origin; ...": of such a jump, for a message.
    static std::string text(const Jump& jump);

private:
    struct Step {
        double size = 0.0;
        double rate = 0.0;
    };

    [[nodiscard]] Pose2 continuous(const Pose2& logged) const;
    [[nodiscard]] Pose2 motion_as_before(double duration_s) const;
    std::optional<Jump> find_jump(const StampedPose& next);

    std::optional<StampedPose> before_;            ///< as logged
    std::deque<StampedPose> latest_;               ///< as logged, the last few tenths of a second without a jump
    std::optional<Pose2> continuous_from_logged_;  ///< empty until the first jump
    Step longest_;                                 ///< metres, and the fastest in metres per second
    Step widest_;                                  ///< radians, and the fastest in radians per second
    std::size_t steps_ = 0;
    std::optional<Jump> last_jump_;
};

}  // namespace ddtool

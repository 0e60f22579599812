#include "run/placed_scans.hpp"

namespace ddtool {

std::optional<SensorFrame> PlacedScans::next() {
    std::optional<SensorFrame> frame = scans_.next();
    if (!frame) {
        return frame;
    }
    if (const std::optional<Pose2> map_from_robot = told_()) {
        // The odometry's next pose is as far from its last one as the pose told is from the filter's.
        const Pose2 placed = before_ ? *before_ * between(filter_.pose(), *map_from_robot) : *map_from_robot;
        placed_from_odom_ = placed * inverse(frame->odom_from_robot);
        frame->odom_step = OdometryStep::measured;
    }
    place(*frame);
    before_ = frame->odom_from_robot;
    return frame;
}

void PlacedScans::place(SensorFrame& frame) const {
    frame.odom_from_robot = placed_from_odom_ * frame.odom_from_robot;
    for (SensorFrame& joined : frame.joined) {
        place(joined);
    }
}

}  // namespace ddtool

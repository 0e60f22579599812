#include "ddtool/robot/trajectory.hpp"

#include <algorithm>

namespace ddtool {

double path_length_m(const Trajectory& trajectory) {
    double length_m = 0.0;
    for (std::size_t i = 1; i < trajectory.size(); ++i) {
        length_m += distance_m(trajectory[i - 1].pose, trajectory[i].pose);
    }
    return length_m;
}

std::optional<Pose2> pose_at(const Trajectory& sorted_by_time, std::int64_t stamp_ns) {
    const auto after = std::lower_bound(sorted_by_time.begin(), sorted_by_time.end(), stamp_ns,
                                        [](const StampedPose& pose, std::int64_t t) { return pose.stamp_ns < t; });
    if (after == sorted_by_time.end()) {
        return std::nullopt;
    }
    if (after->stamp_ns == stamp_ns) {
        return after->pose;
    }
    if (after == sorted_by_time.begin()) {
        return std::nullopt;
    }
    const StampedPose& before = *(after - 1);
    const double fraction =
        static_cast<double>(stamp_ns - before.stamp_ns) / static_cast<double>(after->stamp_ns - before.stamp_ns);
    return interpolate(before.pose, after->pose, fraction);
}

}  // namespace ddtool

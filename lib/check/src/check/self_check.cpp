#include "check/self_check.hpp"

#include <algorithm>

namespace ddtool::check {

void SelfCheck::add(const SensorFrame& frame, const std::optional<Update>& update) {
    kept_.offer(frame, update.has_value());
    if (update) {
        odometry_.add(*update);
    }
}

Evidence SelfCheck::evidence(const Trajectory& path) const {
    // the scan whose update ended the run, where its map could not grow, has no pose
    std::vector<KeptScan> scans = kept_.scans();
    std::erase_if(scans, [&](const KeptScan& scan) { return scan.index >= path.size(); });
    std::vector<Pose2> poses;
    std::vector<Pose2> by_odometry;
    for (const KeptScan& scan : scans) {
        poses.push_back(path[scan.index].pose);
        by_odometry.push_back(scan.odom_from_robot);
    }
    return {.scans = scans.size(),
            .neighbours = neighbours(scans, poses),
            .revisits = revisits(scans, poses),
            .odometry_neighbours = neighbours(scans, by_odometry),
            .odometry_revisits = revisits(scans, by_odometry),
            .odometry = odometry_.evidence(),
            .open = open_stretches(scans, poses)};
}

}  // namespace ddtool::check

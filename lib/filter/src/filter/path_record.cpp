#include "ddtool/filter/path_record.hpp"

#include <algorithm>

namespace ddtool {
namespace {

/// The past of the particles is settled only up to this many updates before the present. The learning of the odometry
/// asks for poses of some dozens of updates back.
constexpr std::uint64_t kept_updates = 1024;

}  // namespace

void PathRecord::add_update(std::int64_t stamp_ns, const Pose2& odometry_motion) {
    odometry_motions_.push_back(odometry_motion);
    scans_.push_back({stamp_ns, updates_, {}, 0.0});
    ++updates_;
}

void PathRecord::add_scan(std::int64_t stamp_ns, const Pose2& odometry_motion, double share) {
    scans_.push_back({stamp_ns, updates_ - 1, odometry_motion, share});
}

PathRecord::Node PathRecord::extend(Node parent, const Pose2& pose) {
    const Node node = history_.add(parent, pose);
    history_.release(parent);
    return node;
}

void PathRecord::visit_trajectory(Node node, const PoseVisitor& visit) const {
    std::ranges::for_each(settled_, visit);
    const std::vector<Pose2> poses = history_.path(node);
    for (const ScanRecord& scan : scans_) {
        visit(pose_of(scan, poses));
    }
}

/// Between two updates the path follows the odometry, and the correction by the second update is spread over the way
/// there: a scan gets the share scan.share of it. `poses` are those of the updates from first_update_ on.
StampedPose PathRecord::pose_of(const ScanRecord& scan, const std::vector<Pose2>& poses) const {
    const std::size_t update = scan.update - first_update_;
    Pose2 correction;
    if (update + 1 < poses.size()) {
        const Pose2 by_odometry = poses[update] * odometry_motions_[update + 1];
        correction = interpolate({}, between(by_odometry, poses[update + 1]), scan.share);
    }
    return {scan.stamp_ns, poses[update] * scan.motion * correction};
}

void PathRecord::settle(std::span<const Node> particles) {
    if (updates_ % kept_updates != 0) {
        return;
    }
    const Node common = history_.ancestor(particles.front(), kept_updates);
    if (!std::all_of(particles.begin(), particles.end(),
                     [&](Node node) { return history_.ancestor(node, kept_updates) == common; })) {
        return;
    }
    const std::vector<Pose2> poses = history_.path(common);
    const std::size_t updates = poses.size() - 1;
    while (scans_.front().update < first_update_ + updates) {
        settled_.push_back(pose_of(scans_.front(), poses));
        scans_.pop_front();
    }
    odometry_motions_.erase(odometry_motions_.begin(),
                            odometry_motions_.begin() + static_cast<std::ptrdiff_t>(updates));
    history_.forget_before(common);
    first_update_ += updates;
}

}  // namespace ddtool

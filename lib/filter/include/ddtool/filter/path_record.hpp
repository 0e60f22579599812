#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <span>
#include <vector>

#include "ddtool/filter/pose_history.hpp"
#include "ddtool/robot/trajectory.hpp"

namespace ddtool {

/// The way a filter has come: a pose per update for each particle's past, and a pose per scan worked out from them. The
/// part of the past that all particles share is kept as one pose per scan, since nothing that is still to come changes
/// it.
class PathRecord {
public:
    using Node = PoseHistory::Node;

    /// A scan that moved the filter, after `odometry_motion` since the update before. Each particle's pose follows by
    /// extend().
    void add_update(std::int64_t stamp_ns, const Pose2& odometry_motion);
    /// A scan since the last update, after `odometry_motion` since then, which is `share` of the way to the next one.
    void add_scan(std::int64_t stamp_ns, const Pose2& odometry_motion, double share);

    /// The pose of a particle at the update added last. Takes over the ownership of `parent`.
    [[nodiscard]] Node extend(Node parent, const Pose2& pose);
    /// One more particle has this past.
    void acquire(Node node) { history_.acquire(node); }
    /// One particle less has it.
    void release(Node node) { history_.release(node); }
    /// Pose so many updates before that of `node` (0: its own). No further back than a thousand updates is certain;
    /// then it is the oldest that is left.
    [[nodiscard]] const Pose2& pose_before(Node node, std::size_t updates) const {
        return history_.pose_before(node, updates);
    }

    /// The odometry since the last update, in the robot's frame there.
    [[nodiscard]] const Pose2& motion_since_update() const { return scans_.back().motion; }
    [[nodiscard]] std::int64_t last_stamp_ns() const { return scans_.back().stamp_ns; }
    /// A pose for every scan so far, by the past of one particle.
    [[nodiscard]] Trajectory trajectory(Node node) const;
    /// Now and then gives back memory of the past that all these particles share. To be called after each update.
    void settle(std::span<const Node> particles);

private:
    struct ScanRecord {
        std::int64_t stamp_ns = 0;
        std::uint64_t update = 0;  ///< the last update at or before the scan
        Pose2 motion;              ///< odometry since that update, in the robot's frame there
        double share = 0.0;        ///< of the way to the next update
    };
    [[nodiscard]] StampedPose pose_of(const ScanRecord& scan, const std::vector<Pose2>& poses) const;

    PoseHistory history_;
    std::deque<StampedPose> settled_;  ///< scans of the past that all particles share; a deque grows without copies
    std::uint64_t updates_ = 0;
    std::uint64_t first_update_ = 0;      ///< the first that is not settled, where history_ begins
    std::deque<ScanRecord> scans_;        ///< since that update
    std::deque<Pose2> odometry_motions_;  ///< odometry motion before it and each update since
};

}  // namespace ddtool

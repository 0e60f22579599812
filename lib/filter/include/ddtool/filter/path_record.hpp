#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <span>
#include <vector>

#include "ddtool/filter/pose_history.hpp"
#include "ddtool/robot/trajectory.hpp"

namespace ddtool {

/// The path of a filter: one pose per update for each particle's past, and one pose per scan computed from them. The
/// part of the past that all particles share is kept as one pose per scan, since no later update changes it.
class PathRecord {
public:
    using Node = PoseHistory::Node;

    /// Adds a scan that updated the filter. `odometry_motion` is the motion since the previous update. Call extend()
    /// afterwards to add each particle's pose.
    void add_update(std::int64_t stamp_ns, const Pose2& odometry_motion);
    /// Adds a scan that did not update the filter. `odometry_motion` is the motion since the last update, and `share`
    /// in 0..1 says how much of the motion that triggers the next update it makes up.
    void add_scan(std::int64_t stamp_ns, const Pose2& odometry_motion, double share);

    /// Adds the pose (world_from_robot) of a particle at the latest update. Takes over the ownership of `parent`; the
    /// caller owns the result.
    [[nodiscard]] Node extend(Node parent, const Pose2& pose);
    /// Records that one more particle has this past.
    void acquire(Node node) { history_.acquire(node); }
    /// Records that one particle fewer has this past.
    void release(Node node) { history_.release(node); }
    /// The pose the given number of updates before that of `node` (0: its own). At least a thousand updates back are
    /// available; beyond the oldest pose kept, it returns that one.
    [[nodiscard]] const Pose2& pose_before(Node node, std::size_t updates) const {
        return history_.pose_before(node, updates);
    }

    /// Odometry motion since the last update, in the robot's frame at that update. Needs an update before it.
    [[nodiscard]] const Pose2& motion_since_update() const { return scans_.back().motion; }
    [[nodiscard]] std::int64_t last_stamp_ns() const { return scans_.back().stamp_ns; }
    /// Calls `visit` with a pose for every scan so far, from the past of one particle.
    void visit_trajectory(Node node, const PoseVisitor& visit) const;
    /// From time to time, frees memory of the past that all these particles share. Call it after each update with the
    /// nodes of all particles.
    void settle(std::span<const Node> particles);

private:
    struct ScanRecord {
        std::int64_t stamp_ns = 0;
        std::uint64_t update = 0;  ///< the last update at or before the scan
        Pose2 motion;              ///< odometry since that update, in the robot's frame at it
        double share = 0.0;        ///< how much of the motion to the next update it makes up
    };
    [[nodiscard]] StampedPose pose_of(const ScanRecord& scan, const std::vector<Pose2>& poses) const;

    PoseHistory history_;
    std::deque<StampedPose> settled_;  ///< scans of the shared past; a deque grows without copies
    std::uint64_t updates_ = 0;
    std::uint64_t first_update_ = 0;      ///< the first update that is not settled, where history_ begins
    std::deque<ScanRecord> scans_;        ///< scans since first_update_
    std::deque<Pose2> odometry_motions_;  ///< motion before first_update_ and before each later update
};

}  // namespace ddtool

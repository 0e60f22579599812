#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "geometry/pose2.hpp"

namespace ddtool {

/// The poses of all living particles since the start, as a tree in which descendants share their past. What no living
/// particle descends from is given back, so memory grows with the run, not with run times particles.
class PoseHistory {
public:
    using Node = std::uint32_t;
    static constexpr Node none = UINT32_MAX;

    /// Adds a pose after `parent` (none: the first). The caller owns the node once.
    Node add(Node parent, const Pose2& pose);
    void acquire(Node node);
    /// Gives up one ownership; nodes without owners and descendants are freed.
    void release(Node node);
    /// The pose so many generations before `node`'s (0: its own), which must be there.
    [[nodiscard]] const Pose2& pose_before(Node node, std::size_t generations) const;
    /// Poses from the first to `node`.
    [[nodiscard]] std::vector<Pose2> path(Node node) const;
    /// Nodes in use.
    [[nodiscard]] std::size_t size() const { return entries_.size() - free_.size(); }

private:
    struct Entry {
        Pose2 pose;
        Node parent = none;
        std::uint32_t owners = 0;  ///< particles and child nodes
    };
    std::vector<Entry> entries_;
    std::vector<Node> free_;
};

}  // namespace ddtool

#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <vector>

#include "ddtool/robot/pose2.hpp"

namespace ddtool {

/// The poses of all living particles, as a tree in which descendants share their past. What no living particle descends
/// from is given back, so memory grows with the run, not with run times particles, and no further than to what is
/// forgotten.
class PoseHistory {
public:
    using Node = std::uint32_t;
    static constexpr Node none = UINT32_MAX;

    /// Adds a pose after `parent` (none: the first). The caller owns the node once.
    Node add(Node parent, const Pose2& pose);
    void acquire(Node node);
    /// Gives up one ownership; nodes without owners and descendants are freed.
    void release(Node node);
    /// The node so many generations before (0: itself), or the first, where there are fewer.
    [[nodiscard]] Node ancestor(Node node, std::size_t generations) const;
    /// Its pose.
    [[nodiscard]] const Pose2& pose_before(Node node, std::size_t generations) const {
        return entries_[ancestor(node, generations)].pose;
    }
    /// Poses from the first to `node`.
    [[nodiscard]] std::vector<Pose2> path(Node node) const;
    /// `node`, from which all that live descend, becomes the first.
    void forget_before(Node node);
    /// Nodes in use.
    [[nodiscard]] std::size_t size() const { return entries_.size() - free_.size(); }

private:
    struct Entry {
        Pose2 pose;
        Node parent = none;
        std::uint32_t owners = 0;  ///< particles and child nodes
    };
    std::deque<Entry> entries_;
    std::vector<Node> free_;
};

}  // namespace ddtool

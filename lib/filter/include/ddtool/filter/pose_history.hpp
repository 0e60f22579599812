#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <vector>

#include "ddtool/robot/pose2.hpp"

namespace ddtool {

/// The poses of all living particles, as a tree in which descendants share their past. Poses that no living particle
/// descends from are freed. Memory therefore grows with the length of the run rather than with its length times the
/// number of particles, and forget_before() limits it further.
class PoseHistory {
public:
    using Node = std::uint32_t;
    static constexpr Node none = UINT32_MAX;

    /// Adds a pose after `parent` (`none` for the first pose). The caller owns the new node once.
    Node add(Node parent, const Pose2& pose);
    /// Adds one ownership of the node.
    void acquire(Node node);
    /// Gives up one ownership; nodes without owners and descendants are freed.
    void release(Node node);
    /// The node the given number of generations before (0: itself), or the first node where there are fewer.
    [[nodiscard]] Node ancestor(Node node, std::size_t generations) const;
    /// The pose of that ancestor.
    [[nodiscard]] const Pose2& pose_before(Node node, std::size_t generations) const {
        return entries_[ancestor(node, generations)].pose;
    }
    /// The poses from the first node to `node`, in order.
    [[nodiscard]] std::vector<Pose2> path(Node node) const;
    /// Makes `node` the first and frees the poses before it. All living nodes must descend from it.
    void forget_before(Node node);
    /// Number of nodes in use.
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

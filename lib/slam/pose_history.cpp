#include "slam/pose_history.hpp"

#include <algorithm>

namespace ddtool {

PoseHistory::Node PoseHistory::add(Node parent, const Pose2& pose) {
    if (parent != none) {
        acquire(parent);
    }
    const Entry entry{pose, parent, 1};
    if (free_.empty()) {
        entries_.push_back(entry);
        return static_cast<Node>(entries_.size() - 1);
    }
    const Node node = free_.back();
    free_.pop_back();
    entries_[node] = entry;
    return node;
}

void PoseHistory::acquire(Node node) { ++entries_[node].owners; }

void PoseHistory::release(Node node) {
    while (node != none && --entries_[node].owners == 0) {
        free_.push_back(node);
        node = entries_[node].parent;
    }
}

const Pose2& PoseHistory::pose_before(Node node, std::size_t generations) const {
    for (; generations > 0; --generations) {
        node = entries_[node].parent;
    }
    return entries_[node].pose;
}

std::vector<Pose2> PoseHistory::path(Node node) const {
    std::vector<Pose2> poses;
    for (; node != none; node = entries_[node].parent) {
        poses.push_back(entries_[node].pose);
    }
    std::reverse(poses.begin(), poses.end());
    return poses;
}

}  // namespace ddtool

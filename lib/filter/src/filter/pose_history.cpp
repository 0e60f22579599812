#include "ddtool/filter/pose_history.hpp"

#include <algorithm>
#include <utility>

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

PoseHistory::Node PoseHistory::ancestor(Node node, std::size_t generations) const {
    for (; generations > 0 && entries_[node].parent != none; --generations) {
        node = entries_[node].parent;
    }
    return node;
}

std::vector<Pose2> PoseHistory::path(Node node) const {
    std::vector<Pose2> poses;
    for (; node != none; node = entries_[node].parent) {
        poses.push_back(entries_[node].pose);
    }
    std::reverse(poses.begin(), poses.end());
    return poses;
}

void PoseHistory::forget_before(Node node) { release(std::exchange(entries_[node].parent, none)); }

}  // namespace ddtool

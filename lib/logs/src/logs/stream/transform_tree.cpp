#include "logs/stream/transform_tree.hpp"

namespace ddtool {

void TransformTree::set(const PoseReading& parent_from_child) {
    parents_[parent_from_child.child_frame_id] = parent_from_child;
}

void TransformTree::set(const TransformTree& other) {
    for (const auto& [child, transform] : other.parents_) {
        parents_[child] = transform;
    }
}

std::vector<std::string> TransformTree::without_rotation(const std::string& target, const std::string& source) const {
    std::vector<std::string> found;
    for (const std::string& frame : with_ancestors(source)) {
        const auto up = parents_.find(frame);
        if (frame == target || up == parents_.end()) {
            break;
        }
        if (!up->second.has_rotation) {
            found.push_back(up->second.frame_id + " -> " + frame);
        }
    }
    return found;
}

std::optional<Eigen::Isometry3d> TransformTree::find(const std::string& target, const std::string& source) const {
    std::vector<std::string> targets = with_ancestors(target);
    std::vector<std::string> sources = with_ancestors(source);
    if (targets.back() != sources.back()) {
        return std::nullopt;
    }
    // Up to the nearest common ancestor only: a pose of the robot in the world would add its rounding errors.
    while (targets.size() > 1 && sources.size() > 1 && targets[targets.size() - 2] == sources[sources.size() - 2]) {
        targets.pop_back();
        sources.pop_back();
    }
    return last_from_first(targets).inverse() * last_from_first(sources);
}

std::vector<std::string> TransformTree::with_ancestors(const std::string& frame) const {
    std::vector<std::string> frames{frame};
    // The limit on the length ends the search if the frames of a damaged log form a loop.
    for (auto up = parents_.find(frame); up != parents_.end() && frames.size() <= parents_.size();
         up = parents_.find(frames.back())) {
        frames.push_back(up->second.frame_id);
    }
    return frames;
}

Eigen::Isometry3d TransformTree::last_from_first(const std::vector<std::string>& frames) const {
    Eigen::Isometry3d last_from_first = Eigen::Isometry3d::Identity();
    for (std::size_t i = 0; i + 1 < frames.size(); ++i) {
        last_from_first = parents_.at(frames[i]).frame_from_child * last_from_first;
    }
    return last_from_first;
}

}  // namespace ddtool

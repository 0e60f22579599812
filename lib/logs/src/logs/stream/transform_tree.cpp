#include "logs/stream/transform_tree.hpp"

namespace ddtool {

void TransformTree::set(const PoseReading& parent_from_child) {
    parents_[parent_from_child.child_frame_id] = parent_from_child;
}

std::optional<Eigen::Isometry3d> TransformTree::find(const std::string& target, const std::string& source) const {
    const std::vector<std::string> targets = with_ancestors(target);
    const std::vector<std::string> sources = with_ancestors(source);
    if (targets.back() != sources.back()) {
        return std::nullopt;
    }
    return root_from(targets).inverse() * root_from(sources);
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

Eigen::Isometry3d TransformTree::root_from(const std::vector<std::string>& frames) const {
    Eigen::Isometry3d root_from_frame = Eigen::Isometry3d::Identity();
    for (std::size_t i = 0; i + 1 < frames.size(); ++i) {
        root_from_frame = parents_.at(frames[i]).frame_from_child * root_from_frame;
    }
    return root_from_frame;
}

}  // namespace ddtool

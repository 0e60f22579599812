#pragma once

#include <Eigen/Geometry>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "logs/messages/readings.hpp"

namespace ddtool {

/// The coordinate frames of a robot, each connected to its parent by the latest known transform (the model of tf2).
class TransformTree {
public:
    void set(const PoseReading& parent_from_child);
    /// Sets all transforms of another tree.
    void set(const TransformTree& other);

    /// target_from_source along the tree; nullopt if the two frames are not connected.
    [[nodiscard]] std::optional<Eigen::Isometry3d> find(const std::string& target, const std::string& source) const;
    /// The frame, its parent, and so on to the root.
    [[nodiscard]] std::vector<std::string> with_ancestors(const std::string& frame) const;
    /// The frames on the way from `source` up to `target`, or to the root, whose transform to their parent has no
    /// rotation in the log (PoseReading::has_rotation), as "parent -> child".
    [[nodiscard]] std::vector<std::string> without_rotation(const std::string& target, const std::string& source) const;

private:
    /// \param frames each the child of the next
    [[nodiscard]] Eigen::Isometry3d last_from_first(const std::vector<std::string>& frames) const;

    std::map<std::string, PoseReading> parents_;  ///< by child
};

}  // namespace ddtool

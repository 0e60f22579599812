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

    /// target_from_source along the tree; nullopt if the two frames are not connected.
    [[nodiscard]] std::optional<Eigen::Isometry3d> find(const std::string& target, const std::string& source) const;
    /// The frame, its parent, and so on to the root.
    [[nodiscard]] std::vector<std::string> with_ancestors(const std::string& frame) const;

private:
    [[nodiscard]] Eigen::Isometry3d root_from(const std::vector<std::string>& frames) const;

    std::map<std::string, PoseReading> parents_;  ///< by child
};

}  // namespace ddtool

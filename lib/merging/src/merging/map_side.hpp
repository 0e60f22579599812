#pragma once

#include <memory>
#include <vector>

#include "graph/stretches.hpp"
#include "maps/saved_map.hpp"

namespace ddtool::merging {

/// Nodes that share a frame, and windows of their path: a few metres each, whose scans make a local map.
class MapSide {
public:
    /// \param nodes the scans with their poses in the common frame
    /// \param settings of the matcher, and the cells in which the local maps are drawn
    MapSide(std::vector<graph::Node> nodes, std::vector<Pose2> poses, const RbpfSettings& settings);
    MapSide(const MapSide&) = delete;
    MapSide& operator=(const MapSide&) = delete;

    [[nodiscard]] const std::vector<Pose2>& poses() const { return poses_; }
    [[nodiscard]] const std::vector<graph::Stretch>& windows() const { return windows_; }
    /// Where the local map of a window has its origin.
    [[nodiscard]] const Pose2& anchor(std::size_t window) const { return poses_[windows_[window].anchor]; }
    /// Throws MapTooLarge.
    [[nodiscard]] std::shared_ptr<const graph::StretchMap> local_map(std::size_t window) const {
        return maps_.map_of(windows_[window]);
    }

private:
    RbpfSettings settings_;
    std::vector<graph::Node> nodes_;
    std::vector<Pose2> poses_;
    std::vector<graph::Stretch> windows_;
    mutable graph::StretchMaps maps_;  ///< keeps the latest few
};

/// The nodes of a saved map as a side. `settings` gives the cells.
std::unique_ptr<MapSide> side_of(const std::vector<maps::MapNode>& nodes, const RbpfSettings& settings);

/// The settings with which maps are compared: those of the filter, in cells like these.
RbpfSettings comparing(const OccupancySettings& cells);

}  // namespace ddtool::merging

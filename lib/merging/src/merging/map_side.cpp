#include "merging/map_side.hpp"

#include <utility>

namespace ddtool::merging {

MapSide::MapSide(std::vector<graph::Node> nodes, std::vector<Pose2> poses, const RbpfSettings& settings)
    : settings_(settings),
      nodes_(std::move(nodes)),
      poses_(std::move(poses)),
      windows_(graph::stretches_of(poses_)),
      maps_(nodes_, poses_, settings_) {}

std::unique_ptr<MapSide> side_of(const std::vector<maps::MapNode>& nodes, const RbpfSettings& settings) {
    std::vector<graph::Node> scans;
    std::vector<Pose2> poses;
    for (const maps::MapNode& node : nodes) {
        scans.push_back(node.scan);
        poses.push_back(node.pose);
    }
    return std::make_unique<MapSide>(std::move(scans), std::move(poses), settings);
}

RbpfSettings comparing(const OccupancySettings& cells) {
    RbpfSettings settings;
    settings.grid = cells;
    return settings;
}

}  // namespace ddtool::merging

#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "ddtool/filter/occupancy_grid.hpp"
#include "ddtool/filter/odometry_model.hpp"
#include "ddtool/system/settings.hpp"
#include "graph/node.hpp"
#include "graph/pose_graph.hpp"

namespace ddtool::maps {

/// A drive that went into a map.
struct Drive {
    std::string log;                        ///< the name of its log
    std::optional<OdometryState> odometry;  ///< what was learnt of its odometry
};

/// A scan that was drawn into a map.
struct MapNode {
    std::uint32_t drive = 0;
    graph::Node scan;
    Pose2 pose;  ///< map_from_robot
};

/// What ties two nodes to each other, as the pose graph had it.
struct MapEdge {
    enum class Kind : std::uint32_t { odometry = 0, match = 1, loop = 2 };
    Kind kind = Kind::odometry;
    graph::RelativeEdge edge;
};

/// A map with what is needed to localise in it, to go on with it and to change it. A map that comes from a picture has
/// a grid alone.
struct SavedMap {
    explicit SavedMap(const OccupancySettings& cells) : grid(cells) {}

    std::string program;             ///< what wrote it
    Json settings = Json::object();  ///< of the run that made it
    std::vector<Drive> drives;
    std::vector<MapNode> nodes;  ///< in the order in which they were drawn; drive after drive
    std::vector<MapEdge> edges;  ///< empty where there was no pose graph
    OccupancyGrid grid;          ///< what the nodes' scans give, drawn at their poses
};

/// The edges of a solved graph, its odometry calibrated. Loops without weight are left out.
std::vector<MapEdge> edges_of(const graph::PoseGraph& graph);

/// The nodes and edges as a graph. Where the map has no edges, those of the odometry take their place, with what was
/// learnt of it.
graph::PoseGraph graph_of(const SavedMap& map);

/// The edges of a map; where it has none, those of its odometry.
std::vector<MapEdge> edges_or_odometry(const SavedMap& map);

/// Adds the drives, scans and edges of `later`, whose poses are those in `map`, behind those of `map`. Where one of the
/// two has no edges, those of its odometry take their place. The grid stays as it is.
void append(SavedMap& map, const SavedMap& later);

/// Draws the nodes' scans, each counting alike. Throws MapTooLarge.
OccupancyGrid drawn(const std::vector<MapNode>& nodes, const OccupancySettings& cells);

/// Draws the map anew from its nodes' scans. From the second drive on, walls fade where scans see through them, as the
/// settings of the map's run say (GoingOnSettings). Throws MapTooLarge.
OccupancyGrid drawn(const SavedMap& map);

}  // namespace ddtool::maps

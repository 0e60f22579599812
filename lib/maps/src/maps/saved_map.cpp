#include "maps/saved_map.hpp"

#include "ddtool/filter/learnt_odometry.hpp"
#include "ddtool/filter/scan_insertion.hpp"
#include "maps/going_on.hpp"

namespace ddtool::maps {
namespace {

LearntOdometry odometry_of(const Drive& drive) {
    return drive.odometry ? LearntOdometry(*drive.odometry) : LearntOdometry();
}

}  // namespace

std::vector<MapEdge> edges_of(const graph::PoseGraph& graph) {
    std::vector<MapEdge> edges;
    const auto add = [&](MapEdge::Kind kind, const graph::RelativeEdge& edge) {
        if (edge.weight > 0.0) {
            edges.push_back({kind, edge});
        }
    };
    for (const graph::OdometryEdge& edge : graph.odometry) {
        add(MapEdge::Kind::odometry, relative_edge(edge, graph.calibration));
    }
    for (const graph::RelativeEdge& edge : graph.matches) {
        add(MapEdge::Kind::match, graph::stretched(edge, graph.match_stretch));
    }
    for (const graph::RelativeEdge& edge : graph.loops) {
        add(MapEdge::Kind::loop, edge);
    }
    return edges;
}

graph::PoseGraph graph_of(const SavedMap& map) {
    graph::PoseGraph graph;
    for (const MapNode& node : map.nodes) {
        graph.poses.push_back(node.pose);
    }
    for (const MapEdge& edge : map.edges) {
        (edge.kind == MapEdge::Kind::loop ? graph.loops : graph.matches).push_back(edge.edge);
    }
    if (!map.edges.empty()) {
        return graph;
    }
    for (std::size_t node = 1; node < map.nodes.size(); ++node) {
        const MapNode& before = map.nodes[node - 1];
        const MapNode& after = map.nodes[node];
        if (before.drive != after.drive) {
            continue;
        }
        const LearntOdometry odometry = odometry_of(map.drives.at(after.drive));
        const Pose2 motion = between(before.scan.odom_from_robot, after.scan.odom_from_robot);
        const MotionSigmas sigmas = odometry.sigmas(motion, after.scan.duration_s);
        // Added so that a node reached without any motion of the odometry is not fixed to the one before.
        constexpr double least_m = 1e-3;
        constexpr double least_rad = 5e-4;
        const graph::OdometryEdge edge{
            .from = node - 1,
            .motion = odometry.expected(motion, after.scan.duration_s),
            .duration_s = 0.0,
            .sigmas = {sigmas.x_m + least_m, sigmas.y_m + least_m, sigmas.theta_rad + least_rad}};
        graph.matches.push_back(relative_edge(edge, {}));
    }
    return graph;
}

std::vector<MapEdge> edges_or_odometry(const SavedMap& map) {
    std::vector<MapEdge> edges = map.edges;
    if (edges.empty()) {
        for (const graph::RelativeEdge& edge : graph_of(map).matches) {
            edges.push_back({MapEdge::Kind::odometry, edge});
        }
    }
    return edges;
}

void append(SavedMap& map, const SavedMap& later) {
    const std::size_t nodes_before = map.nodes.size();
    const auto drives_before = static_cast<std::uint32_t>(map.drives.size());
    map.edges = edges_or_odometry(map);
    for (MapEdge edge : edges_or_odometry(later)) {
        edge.edge.from += nodes_before;
        edge.edge.to += nodes_before;
        map.edges.push_back(edge);
    }
    map.drives.insert(map.drives.end(), later.drives.begin(), later.drives.end());
    map.nodes.insert(map.nodes.end(), later.nodes.begin(), later.nodes.end());
    for (std::size_t node = nodes_before; node < map.nodes.size(); ++node) {
        map.nodes[node].drive += drives_before;
    }
}

OccupancyGrid drawn(const std::vector<MapNode>& nodes, const OccupancySettings& cells) {
    OccupancyGrid grid(cells);
    ScanInserter inserter;
    for (const MapNode& node : nodes) {
        inserter.insert(grid, node.scan.points.unpacked(), node.pose);
    }
    return grid;
}

OccupancyGrid drawn(const SavedMap& map) {
    const int half_life_scans = half_life_of(map.settings);
    OccupancyGrid grid(map.grid.settings());
    ScanInserter inserter;
    for (const MapNode& node : map.nodes) {
        if (node.drive != map.nodes.front().drive) {
            grid.fade(half_life_scans);
        }
        inserter.insert(grid, node.scan.points.unpacked(), node.pose);
    }
    return grid;
}

}  // namespace ddtool::maps

#include "sim/corridor_lattice.hpp"

#include <cmath>
#include <numbers>
#include <set>

namespace ddtool::sim {

LatticeNode neighbour(const LatticeNode& node, std::uint64_t direction) {
    constexpr int steps[4][2] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
    return {node.first + steps[direction][0], node.second + steps[direction][1]};
}

CorridorLattice::CorridorLattice(double half_width_m, std::vector<double> x_m, std::vector<double> y_m)
    : half_width_m_(half_width_m), x_m_(std::move(x_m)), y_m_(std::move(y_m)) {}

Point2 CorridorLattice::at(const LatticeNode& node) const {
    return {x_m_[static_cast<std::size_t>(node.first)], y_m_[static_cast<std::size_t>(node.second)]};
}

std::vector<CorridorWall> CorridorLattice::walls(const std::vector<LatticeNode>& path) const {
    std::vector<CorridorWall> walls;
    std::set<std::pair<LatticeNode, LatticeNode>> joined;
    for (std::size_t i = 1; i < path.size(); ++i) {
        const bool is_new = joined.insert({path[i - 1], path[i]}).second;
        joined.insert({path[i], path[i - 1]});
        if (is_new) {
            add_sides(at(path[i - 1]), at(path[i]), walls);
        }
    }
    for (const LatticeNode& node : std::set<LatticeNode>(path.begin(), path.end())) {
        for (std::uint64_t direction = 0; direction < 4; ++direction) {
            if (!joined.contains({node, neighbour(node, direction)})) {
                walls.push_back(end(at(node), direction));
            }
        }
    }
    return walls;
}

Route CorridorLattice::route(const std::vector<LatticeNode>& path) const {
    const Point2 first = at(path[0]);
    const Point2 second = at(path[1]);
    Route route;
    route.start = {first.x_m, first.y_m, std::atan2(second.y_m - first.y_m, second.x_m - first.x_m)};
    for (std::size_t i = 1; i < path.size(); ++i) {
        route.way_points.push_back(at(path[i]));
    }
    return route;
}

/// The two side walls of a corridor. They leave out the squares around the nodes at both ends.
void CorridorLattice::add_sides(const Point2& from, const Point2& to, std::vector<CorridorWall>& walls) const {
    const double length_m = std::hypot(to.x_m - from.x_m, to.y_m - from.y_m);
    const Pose2 world_from_corridor{from.x_m, from.y_m, std::atan2(to.y_m - from.y_m, to.x_m - from.x_m)};
    for (const double side : {-1.0, 1.0}) {
        const double side_m = side * half_width_m_;
        const Point2 outside = world_from_corridor * Point2{0.0, side};
        walls.push_back({{world_from_corridor * Point2{half_width_m_, side_m},
                          world_from_corridor * Point2{length_m - half_width_m_, side_m}},
                         {outside.x_m - from.x_m, outside.y_m - from.y_m}});
    }
}

CorridorWall CorridorLattice::end(const Point2& node, std::uint64_t direction) const {
    const Pose2 world_from_node{node.x_m, node.y_m, static_cast<double>(direction) * std::numbers::pi / 2.0};
    const Point2 outside = world_from_node * Point2{1.0, 0.0};
    return {{world_from_node * Point2{half_width_m_, -half_width_m_},
             world_from_node * Point2{half_width_m_, half_width_m_}},
            {outside.x_m - node.x_m, outside.y_m - node.y_m},
            /*is_end=*/true};
}

}  // namespace ddtool::sim

#include <cmath>
#include <set>
#include <utility>

#include "ddtool/base/random.hpp"
#include "sim/random_purpose.hpp"
#include "sim/random_worlds.hpp"

namespace ddtool::sim {
namespace {

using Node = std::pair<int, int>;  ///< column and row of a lattice whose lines are unevenly spaced

constexpr int lattice_size = 9;

std::vector<double> draw_lines(RandomStream& random) {
    std::vector<double> lines{0.0};
    for (int i = 1; i < lattice_size; ++i) {
        lines.push_back(lines.back() + random.uniform(8.0, 45.0));
    }
    return lines;
}

Node neighbour(const Node& node, std::uint64_t direction) {
    constexpr int steps[4][2] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
    return {node.first + steps[direction][0], node.second + steps[direction][1]};
}

bool inside(const Node& node) {
    return node.first >= 0 && node.second >= 0 && node.first < lattice_size && node.second < lattice_size;
}

/// A random walk from the middle of the lattice that visits no node twice.
std::vector<Node> draw_walk(std::size_t length, RandomStream& random) {
    std::vector<Node> walk{{lattice_size / 2, lattice_size / 2}};
    std::set<Node> visited{walk.front()};
    for (int tries = 0; walk.size() <= length && tries < 100; ++tries) {
        const Node next = neighbour(walk.back(), random.index(4));
        if (inside(next) && visited.insert(next).second) {
            walk.push_back(next);
        }
    }
    return walk;
}

std::vector<Node> draw_ring(RandomStream& random) {
    const int width = 1 + static_cast<int>(random.index(2));
    const int height = 1 + static_cast<int>(random.index(2));
    std::vector<Node> ring;
    Node node{lattice_size / 2, lattice_size / 2};
    for (std::uint64_t direction = 0; direction < 4; ++direction) {
        for (int i = 0; i < (direction % 2 == 0 ? width : height); ++i) {
            ring.push_back(node);
            node = neighbour(node, direction);
        }
    }
    ring.push_back(node);
    return ring;
}

class CorridorBuilder {
public:
    CorridorBuilder(World& world, RandomStream& random)
        : world_(world), half_width_m_(random.uniform(0.5, 1.5)), x_m_(draw_lines(random)), y_m_(draw_lines(random)) {}

    [[nodiscard]] Point2 at(const Node& node) const {
        return {x_m_[static_cast<std::size_t>(node.first)], y_m_[static_cast<std::size_t>(node.second)]};
    }

    void build(const std::vector<Node>& path) {
        std::set<std::pair<Node, Node>> joined;
        for (std::size_t i = 1; i < path.size(); ++i) {
            joined.insert({path[i - 1], path[i]});
            joined.insert({path[i], path[i - 1]});
            add_sides(at(path[i - 1]), at(path[i]));
        }
        for (const Node& node : std::set<Node>(path.begin(), path.end())) {
            for (std::uint64_t direction = 0; direction < 4; ++direction) {
                if (!joined.contains({node, neighbour(node, direction)})) {
                    close(at(node), direction);
                }
            }
        }
    }

private:
    /// Adds the two side walls of a corridor. They leave out the squares around the nodes at both ends.
    void add_sides(const Point2& from, const Point2& to) {
        const double length_m = std::hypot(to.x_m - from.x_m, to.y_m - from.y_m);
        const Pose2 world_from_corridor{from.x_m, from.y_m, std::atan2(to.y_m - from.y_m, to.x_m - from.x_m)};
        for (const double side_m : {-half_width_m_, half_width_m_}) {
            world_.segments.push_back({world_from_corridor * Point2{half_width_m_, side_m},
                                       world_from_corridor * Point2{length_m - half_width_m_, side_m}});
        }
    }

    void close(const Point2& node, std::uint64_t direction) {
        const Pose2 world_from_node{node.x_m, node.y_m, static_cast<double>(direction) * std::numbers::pi / 2.0};
        world_.segments.push_back({world_from_node * Point2{half_width_m_, -half_width_m_},
                                   world_from_node * Point2{half_width_m_, half_width_m_}});
    }

    World& world_;
    double half_width_m_;
    std::vector<double> x_m_;
    std::vector<double> y_m_;
};

}  // namespace

World random_corridors(std::uint64_t seed) {
    RandomStream random({seed, random_layout, 2});
    World world{.name = "random:corridors:" + std::to_string(seed),
                .description = "corridors at right angles, drawn by seed",
                .segments = {},
                .arcs = {},
                .route = {}};
    CorridorBuilder builder(world, random);
    const bool ring = random.uniform() < 0.4;
    std::vector<Node> path = ring ? draw_ring(random) : draw_walk(3 + random.index(5), random);
    builder.build(path);
    if (!ring) {
        path.insert(path.end(), path.rbegin() + 1, path.rend());
    }
    const Point2 first = builder.at(path[0]);
    const Point2 second = builder.at(path[1]);
    world.route.start = {first.x_m, first.y_m, std::atan2(second.y_m - first.y_m, second.x_m - first.x_m)};
    for (std::size_t i = 1; i < path.size(); ++i) {
        world.route.way_points.push_back(builder.at(path[i]));
    }
    return world;
}

}  // namespace ddtool::sim

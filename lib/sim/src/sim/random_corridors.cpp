#include <set>
#include <utility>
#include <vector>

#include "ddtool/base/random.hpp"
#include "sim/corridor_lattice.hpp"
#include "sim/random_purpose.hpp"
#include "sim/random_worlds.hpp"

namespace ddtool::sim {
namespace {

constexpr int lattice_size = 9;

std::vector<double> draw_lines(RandomStream& random) {
    std::vector<double> lines{0.0};
    for (int i = 1; i < lattice_size; ++i) {
        lines.push_back(lines.back() + random.uniform(8.0, 45.0));
    }
    return lines;
}

bool inside(const LatticeNode& node) {
    return node.first >= 0 && node.second >= 0 && node.first < lattice_size && node.second < lattice_size;
}

/// A random walk from the middle of the lattice that visits no node twice.
std::vector<LatticeNode> draw_walk(std::size_t length, RandomStream& random) {
    std::vector<LatticeNode> walk{{lattice_size / 2, lattice_size / 2}};
    std::set<LatticeNode> visited{walk.front()};
    for (int tries = 0; walk.size() <= length && tries < 100; ++tries) {
        const LatticeNode next = neighbour(walk.back(), random.index(4));
        if (inside(next) && visited.insert(next).second) {
            walk.push_back(next);
        }
    }
    return walk;
}

std::vector<LatticeNode> draw_ring(RandomStream& random) {
    const int width = 1 + static_cast<int>(random.index(2));
    const int height = 1 + static_cast<int>(random.index(2));
    std::vector<LatticeNode> ring;
    LatticeNode node{lattice_size / 2, lattice_size / 2};
    for (std::uint64_t direction = 0; direction < 4; ++direction) {
        for (int i = 0; i < (direction % 2 == 0 ? width : height); ++i) {
            ring.push_back(node);
            node = neighbour(node, direction);
        }
    }
    ring.push_back(node);
    return ring;
}

}  // namespace

World random_corridors(std::uint64_t seed) {
    RandomStream random({seed, random_layout, 2});
    World world{.name = "random:corridors:" + std::to_string(seed),
                .description = "corridors at right angles, drawn by seed",
                .segments = {},
                .arcs = {},
                .route = {}};
    const double half_width_m = random.uniform(0.5, 1.5);
    std::vector<double> x_m = draw_lines(random);
    std::vector<double> y_m = draw_lines(random);
    const CorridorLattice lattice(half_width_m, std::move(x_m), std::move(y_m));
    const bool ring = random.uniform() < 0.4;
    std::vector<LatticeNode> path = ring ? draw_ring(random) : draw_walk(3 + random.index(5), random);
    for (const CorridorWall& wall : lattice.walls(path)) {
        world.segments.push_back(wall.segment);
    }
    if (!ring) {
        path.insert(path.end(), path.rbegin() + 1, path.rend());
    }
    world.route = lattice.route(path);
    return world;
}

}  // namespace ddtool::sim

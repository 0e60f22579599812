#include <cmath>
#include <string>
#include <vector>

#include "ddtool/base/random.hpp"
#include "sim/corridor_lattice.hpp"
#include "sim/random_purpose.hpp"
#include "sim/random_worlds.hpp"

namespace ddtool::sim {
namespace {

/// Recesses keep this distance from the ends of a wall.
constexpr double recess_margin_m = 0.5;

/// A wall with recesses, as closed doors make them: 0.8 to 1.2 m wide, 0.1 to 0.5 m deep and 2 to 10 m apart.
void add_recessed_wall(World& world, const CorridorWall& wall, RandomStream& random) {
    const Point2& from = wall.segment.a;
    const Point2& to = wall.segment.b;
    const double length_m = std::hypot(to.x_m - from.x_m, to.y_m - from.y_m);
    const Point2 along{(to.x_m - from.x_m) / length_m, (to.y_m - from.y_m) / length_m};
    const auto at = [&](double along_m, double depth_m) {
        return Point2{from.x_m + along_m * along.x_m + depth_m * wall.outwards.x_m,
                      from.y_m + along_m * along.y_m + depth_m * wall.outwards.y_m};
    };
    std::vector<Point2> line{at(0.0, 0.0)};
    double start_m = recess_margin_m + random.uniform(0.0, 5.0);
    while (true) {
        const double end_m = start_m + random.uniform(0.8, 1.2);
        const double depth_m = random.uniform(0.1, 0.5);
        if (end_m > length_m - recess_margin_m) {
            break;
        }
        line.push_back(at(start_m, 0.0));
        line.push_back(at(start_m, depth_m));
        line.push_back(at(end_m, depth_m));
        line.push_back(at(end_m, 0.0));
        start_m = end_m + random.uniform(2.0, 10.0);
    }
    line.push_back(at(length_m, 0.0));
    add_polyline(world, line);
}

World recessed(const std::string& name, const std::string& description, const CorridorLattice& lattice,
               const std::vector<LatticeNode>& path, RandomStream& random) {
    World world{.name = name, .description = description, .segments = {}, .arcs = {}, .route = lattice.route(path)};
    for (const CorridorWall& wall : lattice.walls(path)) {
        if (wall.is_end) {
            world.segments.push_back(wall.segment);
        } else {
            add_recessed_wall(world, wall, random);
        }
    }
    return world;
}

}  // namespace

World random_recessed_corridor(std::uint64_t seed) {
    RandomStream random({seed, random_layout, 4});
    const CorridorLattice lattice(random.uniform(0.8, 1.2), {0.0, 140.0}, {0.0});
    return recessed("random:recessed-corridor:" + std::to_string(seed),
                    "a corridor of 140 m with recesses, there and back, drawn by seed", lattice,
                    {{0, 0}, {1, 0}, {0, 0}}, random);
}

World random_recessed_ring(std::uint64_t seed) {
    RandomStream random({seed, random_layout, 5});
    const double width_m = random.uniform(20.0, 30.0);
    const CorridorLattice lattice(random.uniform(0.8, 1.2), {0.0, width_m}, {0.0, 50.0 - width_m});
    return recessed("random:recessed-ring:" + std::to_string(seed),
                    "a ring of corridors with recesses, 100 m around, one lap and a quarter, drawn by seed", lattice,
                    {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0}, {1, 0}}, random);
}

World random_recessed_eight(std::uint64_t seed) {
    RandomStream random({seed, random_layout, 6});
    const double first_m = random.uniform(15.0, 25.0);
    const double second_m = random.uniform(15.0, 25.0);
    const std::vector<double> lines{0.0, first_m, first_m + second_m};
    const CorridorLattice lattice(random.uniform(0.8, 1.2), lines, lines);
    return recessed("random:recessed-eight:" + std::to_string(seed),
                    "two rings of corridors with recesses that meet at a crossing, drawn by seed", lattice,
                    {{1, 1}, {2, 1}, {2, 2}, {1, 2}, {1, 1}, {1, 0}, {0, 0}, {0, 1}, {1, 1}, {2, 1}}, random);
}

}  // namespace ddtool::sim

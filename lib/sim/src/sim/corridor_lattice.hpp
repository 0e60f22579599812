#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "sim/world.hpp"

namespace ddtool::sim {

/// Column and row of a crossing of the lattice.
using LatticeNode = std::pair<int, int>;

/// The node one step from `node` in a direction: 0 along x, 1 along y, 2 against x, 3 against y.
LatticeNode neighbour(const LatticeNode& node, std::uint64_t direction);

struct CorridorWall {
    Segment segment;
    Point2 outwards;      ///< unit vector away from the corridor
    bool is_end = false;  ///< closes a crossing where no corridor leads on
};

/// Corridors of one width along the lines of a lattice, whose lines may be unevenly spaced. Metres, in the world frame.
class CorridorLattice {
public:
    /// x_m and y_m: where the columns and rows are, in increasing order, farther apart than a corridor is wide.
    CorridorLattice(double half_width_m, std::vector<double> x_m, std::vector<double> y_m);

    [[nodiscard]] Point2 at(const LatticeNode& node) const;
    /// The walls of the corridors along a path, each node of which is a neighbour of the one before it. A path may
    /// cross and repeat itself.
    [[nodiscard]] std::vector<CorridorWall> walls(const std::vector<LatticeNode>& path) const;
    /// The route along the middle of the corridors, from the first node of a path to its last. It has at least two
    /// nodes.
    [[nodiscard]] Route route(const std::vector<LatticeNode>& path) const;

private:
    void add_sides(const Point2& from, const Point2& to, std::vector<CorridorWall>& walls) const;
    [[nodiscard]] CorridorWall end(const Point2& node, std::uint64_t direction) const;

    double half_width_m_;
    std::vector<double> x_m_;
    std::vector<double> y_m_;
};

}  // namespace ddtool::sim

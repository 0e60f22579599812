#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "sim/world.hpp"

namespace ddtool::matcher_bench {

/// A kind of world that the bench draws at random.
struct WorldKind {
    std::string name;
    std::string description;
};

/// All kinds, in the order of the tables.
const std::vector<WorldKind>& world_kinds();

struct BenchWorld {
    sim::World world;
    /// The direction of the corridor, in which the robot drives but for a little wandering; nullopt in a room.
    std::optional<double> along_rad;
};

/// The world of a kind that is drawn with the number `layout`, and a route through it. Corridors go on beyond both ends
/// of the route by more than any lidar of the bench sees, so that no end wall is in sight. Every second layout is
/// turned by a random angle; the others lie along the axes of the map, as corridors do that a robot starts to drive
/// along. Throws UsageError for an unknown kind.
/// \param length_m of the route; a room has the same route whatever the length
BenchWorld draw_world(const std::string& kind, std::uint64_t layout, double length_m);

}  // namespace ddtool::matcher_bench

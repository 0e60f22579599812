#pragma once

#include <cstdint>

#include "sim/world.hpp"

namespace ddtool::sim {

/// Random worlds for training and held-out tests. The same seed gives the same world; the route keeps a distance of at
/// least 0.35 m from everything.

/// A corridor with rooms on both sides, doors, furniture; the robot visits some of the rooms.
World random_office(std::uint64_t seed);
/// Corridors of one width (1 to 3 m) and 8 to 45 m length, joined at right angles, there and back or as a ring.
World random_corridors(std::uint64_t seed);
/// Open ground with landmarks (sparse to dense), some walls, and a loop to drive.
World random_open(std::uint64_t seed);

}  // namespace ddtool::sim

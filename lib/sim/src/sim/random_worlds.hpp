#pragma once

#include <cstdint>

#include "sim/world.hpp"

namespace ddtool::sim {

/// Random worlds for training and held-out tests. The same seed gives the same world; the route keeps a distance of at
/// least 0.35 m from everything.

/// A corridor with rooms, doors and furniture on both sides. The robot visits some of the rooms.
World random_office(std::uint64_t seed);
/// Corridors of the same width (1 to 3 m) and of 8 to 45 m length that meet at right angles. The robot drives there and
/// back, or around a ring.
World random_corridors(std::uint64_t seed);
/// Open ground with few to many landmarks, some of them walls, and a loop for the robot to drive.
World random_open(std::uint64_t seed);

}  // namespace ddtool::sim

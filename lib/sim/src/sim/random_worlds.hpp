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
/// Corridors 1.6 to 2.4 m wide with recesses in both walls, 0.1 to 0.5 m deep and 2 to 10 m apart, as closed doors make
/// them. A straight one of 140 m, there and back;
World random_recessed_corridor(std::uint64_t seed);
/// a ring, 100 m around, one lap and one more side;
World random_recessed_ring(std::uint64_t seed);
/// and a figure of eight, two rings of 60 to 100 m that meet at a crossing, both driven once, and the first side again.
World random_recessed_eight(std::uint64_t seed);

}  // namespace ddtool::sim

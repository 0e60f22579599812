#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "ddtool/swarm/particle_snapshot.hpp"

namespace ddtool {

/// Particles farther from each other than this stand for different places.
inline constexpr double mode_m = 0.5;
inline constexpr double mode_rad = 0.35;

/// Particles that stand for the same place: those near the first of them, which has the highest weight.
struct Mode {
    std::vector<std::size_t> particles;
    double weight = 0.0;
};

/// The modes of a swarm, the one with the highest weight first. Of a particle only the pose and the weight count.
std::vector<Mode> modes_of(std::span<const SnapshotParticle> particles);

}  // namespace ddtool

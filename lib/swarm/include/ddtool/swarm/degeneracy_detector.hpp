#pragma once

#include <functional>

#include "ddtool/swarm/particle_snapshot.hpp"

namespace ddtool {

struct Degeneracy {
    double degree = 0.0;  ///< c in 0..1: 0 is well constrained, 1 is degenerate
};

/// Judges how degenerate a swarm is: a network, a covariance test, or a lambda of a test. An empty function means that
/// the swarm never counts as degenerate.
using DegeneracyDetector = std::function<Degeneracy(const ParticleSnapshot&)>;

}  // namespace ddtool

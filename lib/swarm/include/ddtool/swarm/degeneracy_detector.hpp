#pragma once

#include <functional>

#include "ddtool/swarm/particle_snapshot.hpp"

namespace ddtool {

struct Degeneracy {
    double degree = 0.0;  ///< c in 0..1: 0 well constrained, 1 degenerate
};

/// A network, a covariance test, "never" or a test's lambda. An empty function means "never".
using DegeneracyDetector = std::function<Degeneracy(const ParticleSnapshot&)>;

}  // namespace ddtool

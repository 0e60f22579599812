#pragma once

#include <cstdint>
#include <vector>

#include "ddtool/base/random.hpp"
#include "ddtool/swarm/particle_snapshot.hpp"

namespace ddtool::train::test {

/// Particles with random values: an oblong swarm of about a metre around (40, -30) m that has moved by about 0.3 m. The
/// log-likelihood of a particle is its number.
inline std::vector<SnapshotParticle> drawn_swarm(std::size_t count, std::uint64_t seed) {
    RandomStream random({seed});
    std::vector<SnapshotParticle> particles(count);
    double number = 0.0;
    for (SnapshotParticle& particle : particles) {
        particle.pose = {40.0 + random.normal(), -30.0 + 0.3 * random.normal(), random.uniform(-3.0, 3.0)};
        particle.predicted_motion = {0.3 + 0.02 * random.normal(), 0.05 * random.normal(), 0.1 * random.normal()};
        particle.matched_motion = {0.3 + 0.01 * random.normal(), 0.03 * random.normal(), 0.1 * random.normal()};
        particle.log_likelihood = number++;
        particle.weight = 1.0 / static_cast<double>(count);
    }
    return particles;
}

}  // namespace ddtool::train::test

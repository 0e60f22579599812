#include "ddtool/swarm/swarm_shape.hpp"

#include "swarm/moments.hpp"

namespace ddtool {

SwarmShape swarm_shape(std::span<const SnapshotParticle> particles, Pose2 SnapshotParticle::*position) {
    PositionMoments moments;
    for (const SnapshotParticle& particle : particles) {
        moments.add(particle.*position, particle.weight);
    }
    return moments.shape();
}

SwarmShape unweighted_swarm_shape(std::span<const SnapshotParticle> particles, Pose2 SnapshotParticle::*position) {
    PositionMoments moments;
    for (const SnapshotParticle& particle : particles) {
        moments.add(particle.*position);
    }
    return moments.shape();
}

}  // namespace ddtool

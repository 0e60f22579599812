// Asks the shipped network about the swarm of one's own particle filter. In the first swarm, matching has moved all
// particles to one place (well constrained); in the second, they are still as spread as odometry predicted
// (degenerate).
#include <iostream>

#include "ddtool/network/network_detector.hpp"
#include "ddtool/network/shipped_model.hpp"

static ddtool::ParticleSnapshot swarm(double share_left) {
    ddtool::ParticleSnapshot snapshot;
    snapshot.odometry_motion = {0.1, 0.0, 0.0};
    for (int i = -15; i < 15; ++i) {
        ddtool::SnapshotParticle particle;
        particle.predicted_motion = {0.1 + 0.002 * i, 0.0, 0.0};
        particle.matched_motion = {0.1 + share_left * 0.002 * i, 0.0, 0.0};
        particle.pose = particle.matched_motion;
        particle.weight = 1.0 / 30.0;
        snapshot.particles.push_back(particle);
    }
    return snapshot;
}

int main() {
    const ddtool::DegeneracyDetector detector = ddtool::network_detector(ddtool::shipped_model());
    std::cout << "held " << detector(swarm(0.0)).degree << ", open " << detector(swarm(1.0)).degree << '\n';
}

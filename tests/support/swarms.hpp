#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "ddtool/base/random.hpp"
#include "ddtool/swarm/particle_snapshot.hpp"

namespace ddtool::test {

struct SwarmShape {
    double sd_x_m = 1.0;
    double sd_y_m = 1.0;
};

/// Particles drawn from a normal distribution about the origin. Poses and matched motions are the same; the predicted
/// motions are the same draws with a standard deviation of predicted_sd_m along x and 0.3 of it along y.
inline std::vector<SnapshotParticle> normal_swarm(std::size_t count, std::uint64_t seed, const SwarmShape& shape,
                                                  double predicted_sd_m = 0.1) {
    RandomStream random({seed});
    std::vector<SnapshotParticle> particles(count);
    for (SnapshotParticle& particle : particles) {
        const double x = random.normal();
        const double y = random.normal();
        particle.pose = {shape.sd_x_m * x, shape.sd_y_m * y, 0.0};
        particle.matched_motion = particle.pose;
        particle.predicted_motion = {predicted_sd_m * x, 0.3 * predicted_sd_m * y, 0.0};
    }
    return particles;
}

/// Particles whose poses and matched motions are the given points.
inline std::vector<SnapshotParticle> swarm_at(const std::vector<Point2>& points) {
    std::vector<SnapshotParticle> particles(points.size());
    for (std::size_t index = 0; index < points.size(); ++index) {
        particles[index].pose = {points[index].x_m, points[index].y_m, 0.0};
        particles[index].matched_motion = particles[index].pose;
    }
    return particles;
}

}  // namespace ddtool::test

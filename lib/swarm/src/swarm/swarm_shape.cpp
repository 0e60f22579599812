#include "ddtool/swarm/swarm_shape.hpp"

#include <algorithm>
#include <cmath>

namespace ddtool {

SwarmShape swarm_shape(std::span<const SnapshotParticle> particles, Pose2 SnapshotParticle::*position) {
    double mean_x = 0.0, mean_y = 0.0, squared_weights = 0.0;
    for (const SnapshotParticle& particle : particles) {
        mean_x += particle.weight * (particle.*position).x_m;
        mean_y += particle.weight * (particle.*position).y_m;
        squared_weights += particle.weight * particle.weight;
    }
    double xx = 0.0, xy = 0.0, yy = 0.0;
    for (const SnapshotParticle& particle : particles) {
        const double dx = (particle.*position).x_m - mean_x;
        const double dy = (particle.*position).y_m - mean_y;
        xx += particle.weight * dx * dx;
        xy += particle.weight * dx * dy;
        yy += particle.weight * dy * dy;
    }
    constexpr double least = 1e-9;
    if (1.0 - squared_weights < least) {
        return {};
    }
    const double scale = 1.0 / (1.0 - squared_weights);
    const double middle = 0.5 * (xx + yy);
    const double half = std::hypot(0.5 * (xx - yy), xy);
    return {scale * (middle + half), scale * std::max(0.0, middle - half), 0.5 * std::atan2(2.0 * xy, xx - yy)};
}

}  // namespace ddtool

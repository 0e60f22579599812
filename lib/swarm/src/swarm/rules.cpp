#include "swarm/rules.hpp"

#include <numeric>
#include <vector>

#include "ddtool/swarm/swarm_shape.hpp"
#include "swarm/weights.hpp"

namespace ddtool {

double spread_m(std::span<const SnapshotParticle> particles, Pose2 SnapshotParticle::*position) {
    return unweighted_swarm_shape(particles, position).major_sd_m();
}

double step_spread_ratio(std::span<const SnapshotParticle> particles) {
    const double predicted_m = spread_m(particles, &SnapshotParticle::predicted_motion);
    return predicted_m > 0.0 ? spread_m(particles, &SnapshotParticle::matched_motion) / predicted_m : 0.0;
}

double covariance_eigenvalue_m2(std::span<const SnapshotParticle> particles, Pose2 SnapshotParticle::*position) {
    return swarm_shape(particles, position).major_variance_m2;
}

double effective_share(std::span<const SnapshotParticle> particles) {
    return effective_sample_size(weights_of(particles)) / static_cast<double>(particles.size());
}

double weight_variance(std::span<const SnapshotParticle> particles) {
    const std::vector<double> weights = weights_of(particles);
    const auto count = static_cast<double>(weights.size());
    const double mean = std::accumulate(weights.begin(), weights.end(), 0.0) / count;
    const double squares = std::accumulate(weights.begin(), weights.end(), 0.0, [&](double sum, double weight) {
        return sum + (weight - mean) * (weight - mean);
    });
    return count < 2.0 ? 0.0 : squares / (count - 1.0);
}

double dispersion(std::span<const SnapshotParticle> particles, double SnapshotParticle::*weight) {
    std::vector<double> weights;
    weights.reserve(particles.size());
    for (const SnapshotParticle& particle : particles) {
        weights.push_back(particle.*weight);
    }
    return dispersion(weights);
}

}  // namespace ddtool

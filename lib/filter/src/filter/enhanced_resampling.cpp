#include "ddtool/filter/enhanced_resampling.hpp"

#include <algorithm>
#include <limits>

#include "swarm/weights.hpp"

namespace ddtool {
namespace {

/// Sets the weights below `least` to zero and normalises the rest. The largest weight is always kept.
std::vector<double> kept_weights(std::vector<double> weights, double least) {
    const double bound = std::min(least, *std::max_element(weights.begin(), weights.end()));
    double sum = 0.0;
    for (double& weight : weights) {
        weight = weight < bound ? 0.0 : weight;
        sum += weight;
    }
    std::transform(weights.begin(), weights.end(), weights.begin(), [&](double weight) { return weight / sum; });
    return weights;
}

/// The pose of the nearest other particle whose weight was kept; the particle's own pose if there is none.
Pose2 nearest_other(std::span<const SnapshotParticle> particles, const std::vector<double>& kept, std::size_t self) {
    Pose2 nearest = particles[self].pose;
    double least_m = std::numeric_limits<double>::infinity();
    for (std::size_t other = 0; other < particles.size(); ++other) {
        const double apart_m = distance_m(particles[other].pose, particles[self].pose);
        if (other != self && kept[other] > 0.0 && apart_m < least_m) {
            least_m = apart_m;
            nearest = particles[other].pose;
        }
    }
    return nearest;
}

}  // namespace

std::vector<Descendant> EnhancedResampling::resample(std::span<const SnapshotParticle> particles,
                                                     RandomStream& random) const {
    const auto count = static_cast<double>(particles.size());
    const std::vector<double> kept = kept_weights(weights_of(particles), settings_.drop_below / count);
    std::vector<Descendant> descendants;
    for (const std::size_t parent : systematic_resampling(kept, random.uniform())) {
        const Pose2& pose = particles[parent].pose;
        const Pose2 mate = nearest_other(particles, kept, parent);
        const double weight =
            std::clamp(count * particles[parent].weight, settings_.least_weight, settings_.most_weight);
        const double sigma_m = settings_.perturbation_m / weight;
        const double x = 0.5 * (pose.x_m + mate.x_m) + sigma_m * random.normal();
        const double y = 0.5 * (pose.y_m + mate.y_m) + sigma_m * random.normal();
        descendants.push_back({parent, {x, y, pose.theta_rad}});
    }
    return descendants;
}

}  // namespace ddtool

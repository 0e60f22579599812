#include "swarm/weights.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace ddtool {

std::vector<double> normalised_weights(std::span<const double> log_weights) {
    double largest = -std::numeric_limits<double>::infinity();
    for (const double value : log_weights) {
        if (std::isfinite(value)) {
            largest = std::max(largest, value);
        }
    }
    std::vector<double> weights(log_weights.size(), 1.0);
    if (std::isfinite(largest)) {
        std::transform(log_weights.begin(), log_weights.end(), weights.begin(),
                       [&](double value) { return std::isfinite(value) ? std::exp(value - largest) : 0.0; });
    }
    const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
    for (double& weight : weights) {
        weight /= sum;
    }
    return weights;
}

std::vector<double> weights_of(std::span<const SnapshotParticle> particles) {
    std::vector<double> weights;
    weights.reserve(particles.size());
    for (const SnapshotParticle& particle : particles) {
        weights.push_back(particle.weight);
    }
    return weights;
}

double effective_sample_size(std::span<const double> weights) {
    return 1.0 / std::inner_product(weights.begin(), weights.end(), weights.begin(), 0.0);
}

std::vector<std::size_t> systematic_resampling(std::span<const double> weights, double offset) {
    std::vector<std::size_t> chosen;
    chosen.reserve(weights.size());
    const double step = 1.0 / static_cast<double>(weights.size());
    double cumulative = 0.0;
    std::size_t last_with_weight = 0;
    for (std::size_t particle = 0; particle < weights.size(); ++particle) {
        cumulative += weights[particle];
        last_with_weight = weights[particle] > 0.0 ? particle : last_with_weight;
        while (chosen.size() < weights.size() && (static_cast<double>(chosen.size()) + offset) * step < cumulative) {
            chosen.push_back(particle);
        }
    }
    while (chosen.size() < weights.size()) {  // by rounding, the sum of the weights may be slightly below 1
        chosen.push_back(last_with_weight);
    }
    return chosen;
}

double dispersion(std::span<const double> weights) {
    if (weights.empty()) {
        return 0.0;
    }
    const auto count = static_cast<double>(weights.size());
    const double mean = std::accumulate(weights.begin(), weights.end(), 0.0) / count;
    double variance = 0.0;
    for (const double weight : weights) {
        variance += (weight - mean) * (weight - mean) / count;
    }
    return mean == 0.0 ? 0.0 : variance / std::abs(mean);
}

}  // namespace ddtool

#include "study/judge/measures.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "swarm/spread.hpp"
#include "swarm/weights.hpp"

namespace ddtool::judge {
namespace {

using Position = Pose2 SnapshotParticle::*;

constexpr double least_spread_m = 1e-4;

std::function<double(Particles)> spread_along(Position position) {
    return [position](Particles swarm) { return spread_m(swarm, position); };
}

std::function<double(Particles)> larger_eigenvalue(Position position) {
    return [position](Particles swarm) { return std::pow(weighted_position_spread(swarm, position).major_m, 2); };
}

double effective_share(Particles swarm) {
    return effective_sample_size(weights_of(swarm)) / static_cast<double>(swarm.size());
}

/// sum (w - mean)^2 / (N - 1): its covariance matrix is a number.
double variance_of_weights(Particles swarm) {
    const std::vector<double> weights = weights_of(swarm);
    const auto count = static_cast<double>(weights.size());
    const double mean = std::accumulate(weights.begin(), weights.end(), 0.0) / count;
    const double squares = std::accumulate(weights.begin(), weights.end(), 0.0, [&](double sum, double weight) {
        return sum + (weight - mean) * (weight - mean);
    });
    return count < 2.0 ? 0.0 : squares / (count - 1.0);
}

}  // namespace

std::vector<Measure> simple_measures(const dataset::LabelSettings& labels) {
    return {{"R of " + labels.dispersion_weight, "weights",
             [labels](Particles swarm) { return labelled_dispersion(dataset::dispersions(swarm), labels); }},
            {"effective sample size", "weights", effective_share},
            {"Switch-SLAM eigenvalue", "weights", variance_of_weights},
            {"Switch-SLAM eigenvalue", "absolute", larger_eigenvalue(&SnapshotParticle::pose)},
            {"Switch-SLAM eigenvalue", "step", larger_eigenvalue(&SnapshotParticle::matched_motion)},
            {"spread", "absolute", spread_along(&SnapshotParticle::pose)},
            {"spread", "step", spread_along(&SnapshotParticle::matched_motion)},
            {"spread of predicted", "step", step_spread_ratio}};
}

Eigen::VectorXd covariance_features(Particles swarm) {
    constexpr Position pose = &SnapshotParticle::pose;
    constexpr Position matched = &SnapshotParticle::matched_motion;
    const std::array spreads{position_spread(swarm, pose), position_spread(swarm, matched),
                             position_spread(swarm, &SnapshotParticle::predicted_motion),
                             weighted_position_spread(swarm, pose), weighted_position_spread(swarm, matched)};
    Eigen::VectorXd features(2 * spreads.size() + 1);
    Eigen::Index next = 0;
    for (const PositionSpread& spread : spreads) {
        features[next++] = std::log(std::max(spread.major_m, least_spread_m));
        features[next++] = std::log(std::max(spread.minor_m, least_spread_m));
    }
    features[next] = std::log(static_cast<double>(swarm.size()));
    return features;
}

}  // namespace ddtool::judge

#include "study/judge/measures.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "ddtool/swarm/swarm_shape.hpp"
#include "swarm/rules.hpp"

namespace ddtool::judge {
namespace {

using Position = Pose2 SnapshotParticle::*;

constexpr double least_spread_m = 1e-4;

std::function<double(Particles)> spread_along(Position position) {
    return [position](Particles swarm) { return spread_m(swarm, position); };
}

std::function<double(Particles)> larger_eigenvalue(Position position) {
    return [position](Particles swarm) { return covariance_eigenvalue_m2(swarm, position); };
}

}  // namespace

std::vector<Measure> simple_measures(const dataset::LabelSettings& labels) {
    return {{"R of " + labels.dispersion_weight, "weights",
             [labels](Particles swarm) { return labelled_dispersion(dataset::dispersions(swarm), labels); }},
            {"effective sample size", "weights", effective_share},
            {"Switch-SLAM eigenvalue", "weights", weight_variance},
            {"Switch-SLAM eigenvalue", "absolute", larger_eigenvalue(&SnapshotParticle::pose)},
            {"Switch-SLAM eigenvalue", "step", larger_eigenvalue(&SnapshotParticle::matched_motion)},
            {"spread", "absolute", spread_along(&SnapshotParticle::pose)},
            {"spread", "step", spread_along(&SnapshotParticle::matched_motion)},
            {"spread of predicted", "step", step_spread_ratio}};
}

Eigen::VectorXd covariance_features(Particles swarm) {
    constexpr Position pose = &SnapshotParticle::pose;
    constexpr Position matched = &SnapshotParticle::matched_motion;
    const std::array shapes{unweighted_swarm_shape(swarm, pose), unweighted_swarm_shape(swarm, matched),
                            unweighted_swarm_shape(swarm, &SnapshotParticle::predicted_motion),
                            swarm_shape(swarm, pose), swarm_shape(swarm, matched)};
    Eigen::VectorXd features(2 * shapes.size() + 1);
    Eigen::Index next = 0;
    for (const SwarmShape& shape : shapes) {
        features[next++] = std::log(std::max(shape.major_sd_m(), least_spread_m));
        features[next++] = std::log(std::max(shape.minor_sd_m(), least_spread_m));
    }
    features[next] = std::log(static_cast<double>(swarm.size()));
    return features;
}

}  // namespace ddtool::judge

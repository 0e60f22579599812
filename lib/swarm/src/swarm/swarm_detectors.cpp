#include "ddtool/swarm/swarm_detectors.hpp"

#include <algorithm>
#include <cmath>

#include "ddtool/base/error.hpp"
#include "ddtool/swarm/swarm_shape.hpp"
#include "swarm/physical_degeneracy.hpp"
#include "swarm/spread.hpp"
#include "swarm/weights.hpp"

namespace ddtool {
namespace {

double squared(double value) { return value * value; }

Degeneracy oracle(const ParticleSnapshot& swarm, const MotionNoise& noise) {
    if (!swarm.fisher_information) {
        throw Error("detector oracle: expected a log with the true Fisher information, as ddtool simulate writes it");
    }
    const PhysicalDegeneracy physics =
        physical_degeneracy(*swarm.fisher_information, motion_sigmas(swarm.odometry_motion, noise));
    // Written so that an infinite sd gives 1.
    return {1.0 / (1.0 + squared(physics.odometry_sd_m / physics.weak_sd_m))};
}

}  // namespace

DegeneracyDetector covariance_detector(double threshold_sd_m) {
    return [threshold_sd_m](const ParticleSnapshot& swarm) -> Degeneracy {
        const double largest = swarm_shape(swarm.particles, &SnapshotParticle::pose).major_variance_m2;
        return {largest / (largest + squared(threshold_sd_m))};
    };
}

DegeneracyDetector step_spread_detector() {
    return [](const ParticleSnapshot& swarm) -> Degeneracy {
        const double predicted = spread_m(swarm.particles, &SnapshotParticle::predicted_motion);
        const double matched = spread_m(swarm.particles, &SnapshotParticle::matched_motion);
        return {predicted > 0.0 ? std::min(1.0, matched / predicted) : 0.0};
    };
}

DegeneracyDetector effective_size_detector() {
    return [](const ParticleSnapshot& swarm) -> Degeneracy {
        const auto count = static_cast<double>(swarm.particles.size());
        return {std::clamp(1.0 - effective_sample_size(weights_of(swarm.particles)) / count, 0.0, 1.0)};
    };
}

DegeneracyDetector always_degenerate() {
    return [](const ParticleSnapshot& /*swarm*/) -> Degeneracy { return {1.0}; };
}

DegeneracyDetector oracle_detector(const MotionNoise& noise) {
    return [noise](const ParticleSnapshot& swarm) { return oracle(swarm, noise); };
}

}  // namespace ddtool

#include "ddtool/swarm/swarm_detectors.hpp"

#include <algorithm>
#include <cmath>

#include "ddtool/base/error.hpp"
#include "swarm/physical_degeneracy.hpp"
#include "swarm/rules.hpp"

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
        const double largest = covariance_eigenvalue_m2(swarm.particles, &SnapshotParticle::pose);
        return {largest / (largest + squared(threshold_sd_m))};
    };
}

DegeneracyDetector step_spread_detector() {
    return
        [](const ParticleSnapshot& swarm) -> Degeneracy { return {std::min(1.0, step_spread_ratio(swarm.particles))}; };
}

DegeneracyDetector effective_size_detector() {
    return [](const ParticleSnapshot& swarm) -> Degeneracy {
        return {std::clamp(1.0 - effective_share(swarm.particles), 0.0, 1.0)};
    };
}

DegeneracyDetector always_degenerate() {
    return [](const ParticleSnapshot& /*swarm*/) -> Degeneracy { return {1.0}; };
}

DegeneracyDetector oracle_detector(const MotionNoise& noise) {
    return [noise](const ParticleSnapshot& swarm) { return oracle(swarm, noise); };
}

}  // namespace ddtool

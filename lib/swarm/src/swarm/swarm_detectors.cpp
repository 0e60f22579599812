#include "ddtool/swarm/swarm_detectors.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/squared.hpp"
#include "ddtool/base/error.hpp"
#include "ddtool/robot/scan_truth.hpp"
#include "swarm/physical_degeneracy.hpp"
#include "swarm/rules.hpp"

namespace ddtool {

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

DegeneracyDetector oracle_detector(const MotionNoise& noise, std::shared_ptr<const ScanTruth> truth) {
    return [noise, truth = std::move(truth)](const ParticleSnapshot& swarm) -> Degeneracy {
        const std::optional<Eigen::Matrix3d> information =
            truth ? truth->fisher_information(swarm.stamp_ns) : std::nullopt;
        if (!information) {
            throw Error(
                "detector oracle: expected a log with the true Fisher information, as ddtool simulate writes it");
        }
        const PhysicalDegeneracy physics =
            physical_degeneracy(*information, motion_sigmas(swarm.odometry_motion, noise));
        // In this form an infinite weak_sd_m gives 1.
        return {1.0 / (1.0 + squared(physics.odometry_sd_m / physics.weak_sd_m))};
    };
}

}  // namespace ddtool

#include "ddtool/filter/update_report.hpp"

#include <vector>

#include "swarm/weights.hpp"

namespace ddtool {

UpdateReport report_of(const ParticleSnapshot& seen, const Degeneracy& degeneracy) {
    std::vector<double> log_likelihoods;
    for (const SnapshotParticle& particle : seen.particles) {
        log_likelihoods.push_back(particle.log_likelihood);
    }
    UpdateReport report;
    report.stamp_ns = seen.stamp_ns;
    report.degeneracy = degeneracy;
    report.dispersion = dispersion(log_likelihoods);
    report.swarm = swarm_shape(seen.particles, &SnapshotParticle::pose);
    return report;
}

Eigen::Matrix3d pose_scatter(const ParticleSnapshot& swarm, const Pose2& centre) {
    Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
    for (const SnapshotParticle& particle : swarm.particles) {
        const Eigen::Vector3d apart(particle.pose.x_m - centre.x_m, particle.pose.y_m - centre.y_m,
                                    wrap_angle(particle.pose.theta_rad - centre.theta_rad));
        scatter += particle.weight * apart * apart.transpose();
    }
    return scatter;
}

double mean_distance_m(const ParticleSnapshot& before, const ParticleSnapshot& after) {
    double sum_m = 0.0;
    for (std::size_t index = 0; index < before.particles.size(); ++index) {
        sum_m += distance_m(before.particles[index].pose, after.particles[index].pose);
    }
    return sum_m / static_cast<double>(before.particles.size());
}

}  // namespace ddtool

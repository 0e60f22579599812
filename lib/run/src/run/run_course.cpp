#include "run/run_course.hpp"

#include "scores/association.hpp"
#include "swarm/weights.hpp"

namespace ddtool {
namespace {

double mean_distance_m(const ParticleSnapshot& before, const ParticleSnapshot& after) {
    double sum_m = 0.0;
    for (std::size_t index = 0; index < before.particles.size(); ++index) {
        sum_m += distance_m(before.particles[index].pose, after.particles[index].pose);
    }
    return sum_m / static_cast<double>(before.particles.size());
}

double dispersion_of(const ParticleSnapshot& swarm) {
    std::vector<double> log_likelihoods;
    for (const SnapshotParticle& particle : swarm.particles) {
        log_likelihoods.push_back(particle.log_likelihood);
    }
    return dispersion(log_likelihoods);
}

}  // namespace

UpdateSummary summary_of(const Update& update) {
    const std::vector<SnapshotParticle>& particles = update.matched.particles;
    return {.stamp_ns = update.matched.stamp_ns,
            .degree = update.degeneracy.degree,
            .dispersion = dispersion_of(update.matched),
            .swarm = swarm_shape(particles, &SnapshotParticle::pose),
            .effective_size = effective_sample_size(weights_of(particles)),
            .corrected_m = mean_distance_m(update.matched, update.corrected),
            .resampled = update.resampled,
            .pose = update.pose,
            .covariance = update.covariance,
            .step_s = update.times.total_s()};
}

void RunCourse::add(const Update& update, const UpdateSummary& summary) {
    worst_.offer(update.matched, update.degeneracy);
    if (seen_++ % every_ != 0) {
        updates_.back().resampled |= summary.resampled;
        return;
    }
    if (updates_.size() == most_) {
        halve();
    }
    updates_.push_back(summary);
}

void RunCourse::halve() {
    const std::size_t left = most_ / 2;
    for (std::size_t row = 0; row < left; ++row) {
        const bool resampled = updates_[2 * row].resampled || updates_[2 * row + 1].resampled;
        updates_[row] = updates_[2 * row];
        updates_[row].resampled = resampled;
    }
    updates_.resize(left);
    every_ *= 2;
}

Trajectory places_of(const std::vector<UpdateSummary>& updates, const Trajectory& path) {
    const StampIndex scans(path);
    Trajectory places;
    places.reserve(updates.size());
    for (const UpdateSummary& update : updates) {
        const auto scan = scans.nearest(update.stamp_ns, 0.0);
        places.push_back({update.stamp_ns, scan ? path[*scan].pose : update.pose});
    }
    return places;
}

}  // namespace ddtool

#include "dataset/labels.hpp"

#include <algorithm>
#include <cmath>

#include "ddtool/base/error.hpp"
#include "swarm/rules.hpp"

namespace ddtool::dataset {
namespace {

Label label_if(bool degenerate) { return degenerate ? Label::degenerate : Label::not_degenerate; }

}  // namespace

std::array<double, 4> dispersions(std::span<const SnapshotParticle> particles) {
    return {dispersion(particles, &SnapshotParticle::log_likelihood),
            dispersion(particles, &SnapshotParticle::log_likelihood_increment),
            dispersion(particles, &SnapshotParticle::match_score), dispersion(particles, &SnapshotParticle::weight)};
}

double labelled_dispersion(const std::array<double, 4>& dispersions, const LabelSettings& settings) {
    const auto* const name =
        std::find(dispersion_weight_names.begin(), dispersion_weight_names.end(), settings.dispersion_weight);
    if (name == dispersion_weight_names.end()) {
        throw UsageError(
            "labels.dispersion_weight: expected log_likelihood, log_likelihood_increment, match_score or "
            "weight, not '" +
            settings.dispersion_weight + "'");
    }
    return dispersions[static_cast<std::size_t>(name - dispersion_weight_names.begin())];
}

Label dispersion_label(const std::array<double, 4>& dispersions, const LabelSettings& settings) {
    return label_if(labelled_dispersion(dispersions, settings) > settings.dispersion_threshold);
}

Label fisher_label(double weak_sd_m, double odometry_sd_m, const LabelSettings& settings) {
    if (std::isnan(weak_sd_m) || std::isnan(odometry_sd_m)) {
        return Label::unknown;
    }
    return label_if(weak_sd_m > settings.fisher_ratio * odometry_sd_m);
}

}  // namespace ddtool::dataset

#include "dataset/labels.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "ddtool/base/error.hpp"
#include "ddtool/filter/rbpf.hpp"
#include "swarm/physical_degeneracy.hpp"
#include "swarm/rules.hpp"

namespace ddtool::dataset {
namespace {

constexpr double unknown_sd = std::numeric_limits<double>::quiet_NaN();

Eigen::Matrix3d matrix_of(const std::array<double, 6>& information) {
    const auto& [xx, xy, xt, yy, yt, tt] = information;
    return (Eigen::Matrix3d() << xx, xy, xt, xy, yy, yt, xt, yt, tt).finished();
}

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

void set_labels(SampleRecord& record, std::span<const SnapshotParticle> particles, const RbpfSettings& filter,
                const LabelSettings& rules) {
    record.dispersion = dispersions(particles);
    PhysicalDegeneracy physical{unknown_sd, unknown_sd, unknown_sd, unknown_sd};
    const bool known = std::none_of(record.information.begin(), record.information.end(),
                                    [](double each) { return std::isnan(each); });
    if (known) {
        physical = physical_degeneracy(
            information_on_map(matrix_of(record.information), record.range_sd_m, filter.grid.cell_size_m),
            motion_sigmas(record.odometry_motion, filter.motion));
    }
    record.weak_sd_m = physical.weak_sd_m;
    record.weak_direction_rad = physical.weak_direction_rad;
    record.strong_sd_m = physical.strong_sd_m;
    record.odometry_sd_m = physical.odometry_sd_m;
    record.label = {dispersion_label(record.dispersion, rules),
                    fisher_label(physical.weak_sd_m, physical.odometry_sd_m, rules)};
}

}  // namespace ddtool::dataset

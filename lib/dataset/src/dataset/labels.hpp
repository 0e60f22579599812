#pragma once

#include <array>
#include <span>
#include <string>

#include "dataset/sample_record.hpp"
#include "swarm/physical_degeneracy.hpp"

namespace ddtool::dataset {

/// The weights of which a snapshot's dispersion R = var(w) / |mean(w)| is taken, in the order of SampleRecord.
inline constexpr std::array<const char*, 4> dispersion_weight_names{"log_likelihood", "log_likelihood_increment",
                                                                    "match_score", "weight"};

struct LabelSettings {
    std::string dispersion_weight = "log_likelihood";  ///< of dispersion_weight_names
    double dispersion_threshold = 1.0;                 ///< degenerate above it (the paper's eq. label_explain)
    double fisher_ratio = 1.0;                         ///< degenerate above it: weak_sd_m / odometry_sd_m
};

/// R over each weight, in the order of dispersion_weight_names.
std::array<double, 4> dispersions(std::span<const SnapshotParticle> particles);

/// R over the weight that the label takes it of. Throws UsageError for an unknown weight.
double labelled_dispersion(const std::array<double, 4>& dispersions, const LabelSettings& settings);
Label dispersion_label(const std::array<double, 4>& dispersions, const LabelSettings& settings);
/// Unknown for sd that are NaN.
Label fisher_label(double weak_sd_m, double odometry_sd_m, const LabelSettings& settings);

}  // namespace ddtool::dataset

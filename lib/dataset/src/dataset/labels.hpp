#pragma once

#include <array>
#include <span>
#include <string>

#include "dataset/sample_record.hpp"

namespace ddtool {
struct RbpfSettings;
}  // namespace ddtool

namespace ddtool::dataset {

/// The weights over which the dispersion R = var(w) / |mean(w)| of a snapshot is computed, in the order of
/// SampleRecord.
inline constexpr std::array<const char*, 4> dispersion_weight_names{"log_likelihood", "log_likelihood_increment",
                                                                    "match_score", "weight"};

struct LabelSettings {
    std::string dispersion_weight = "log_likelihood";  ///< one of dispersion_weight_names
    double dispersion_threshold = 1.0;  ///< a sample with a larger R is degenerate (the paper's eq. label_explain)
    double fisher_ratio = 1.0;          ///< a sample with a larger weak_sd_m / odometry_sd_m is degenerate
};

/// R over each weight, in the order of dispersion_weight_names.
std::array<double, 4> dispersions(std::span<const SnapshotParticle> particles);

/// R over the weight that the label rule uses. Throws UsageError for an unknown weight.
double labelled_dispersion(const std::array<double, 4>& dispersions, const LabelSettings& settings);
Label dispersion_label(const std::array<double, 4>& dispersions, const LabelSettings& settings);
/// The label is unknown if a standard deviation is NaN.
Label fisher_label(double weak_sd_m, double odometry_sd_m, const LabelSettings& settings);

/// Fills in everything of a record that follows from the snapshot and the scan's information: dispersions, physical
/// bounds and both labels. The filter's settings give the noise of the odometry and the cell size of the map. Without
/// information the bounds are NaN and the label `fisher` is unknown.
void set_labels(SampleRecord& record, std::span<const SnapshotParticle> particles, const RbpfSettings& filter,
                const LabelSettings& rules);

}  // namespace ddtool::dataset

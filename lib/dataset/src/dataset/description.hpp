#pragma once

#include "dataset/dataset.hpp"
#include "report/table.hpp"

namespace ddtool::dataset {

/// The number of samples of each class in the parts of each split, by label rule.
Table class_table(const Counts& counts);

/// The number of samples and the share of degenerate ones, by family of scenes, number of particles, lidar, odometry
/// and update distance.
Table group_table(const Dataset& data);

/// How well the measures agree with the physics: over simulated worlds and over logs, for R over each weight and for
/// the spreads of both swarms, the area under the ROC curve for the label `fisher` and the rank correlation with
/// weak_sd_m, what the scan leaves open. `accuracy` is the share of samples whose two labels are the same. Logs have no
/// label `fisher`, hence only the correlation.
Table agreement_table(const Dataset& data);

/// The tables as JSON, for other programs.
Json description_json(const Dataset& data);

/// The standard deviation that the scan leaves along the weakest direction, divided by that of the odometry. Infinite
/// if the scan does not determine the pose along it, NaN if it is unknown.
double physical_ratio(const SampleRecord& sample);

}  // namespace ddtool::dataset

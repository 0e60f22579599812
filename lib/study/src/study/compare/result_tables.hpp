#pragma once

#include <vector>

#include "report/table.hpp"
#include "study/compare/summary.hpp"

namespace ddtool::compare {

/// One row for each world and one column for each contestant: the median and quartiles of the world's main metric, and
/// * where the difference from the baseline is significant at 0.05 after correction for the number of tests.
Table overview_table(const Experiment& experiment, const std::vector<Summary>& summaries);

/// One row for each world and contestant: median, spread and test of one metric.
Table metric_table(const Experiment& experiment, const std::vector<Summary>& summaries, std::size_t metric);

/// The rows of metric_table() for all metrics, one metric after the other, with the metric as an additional column.
Table full_table(const Experiment& experiment, const std::vector<Summary>& summaries);

/// One row for each world and method, with the medians of ATE, Error_x and Error_y beside what the paper prints, and
/// both changes of ATE against the baseline: ours is the median over the seeds of the change with the same seed, with
/// quartiles. Methods that only the paper has follow the contestants. Empty where experiment.paper is.
Table paper_table(const Experiment& experiment, const std::vector<Summary>& summaries);

/// One row for each run that failed: world, contestant, seed and the reason.
Table failure_table(const Experiment& experiment, const std::vector<Cell>& cells,
                    const std::vector<CellResult>& results);

}  // namespace ddtool::compare

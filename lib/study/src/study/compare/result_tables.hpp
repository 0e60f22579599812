#pragma once

#include <vector>

#include "report/table.hpp"
#include "study/compare/summary.hpp"

namespace ddtool::compare {

/// A row a world, a column a contestant: the median of the world's main metric, quartiles, and * where the difference
/// from the baseline is significant at 0.05 after correction.
Table overview_table(const Experiment& experiment, const std::vector<Summary>& summaries);

/// A row a world and contestant: median, spread and test of one metric.
Table metric_table(const Experiment& experiment, const std::vector<Summary>& summaries, std::size_t metric);

/// The same for all metrics, one after the other, with the metric as a column.
Table full_table(const Experiment& experiment, const std::vector<Summary>& summaries);

/// A row a run that failed: world, contestant, seed and why.
Table failure_table(const Experiment& experiment, const std::vector<Cell>& cells,
                    const std::vector<CellResult>& results);

}  // namespace ddtool::compare

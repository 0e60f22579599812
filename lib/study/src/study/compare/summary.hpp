#pragma once

#include <optional>
#include <string>
#include <vector>

#include "scores/statistics.hpp"
#include "study/compare/runner.hpp"

namespace ddtool::compare {

/// One figure of a trajectory's score; see docs/scoring.md.
struct Metric {
    std::string name;
    std::string unit;
    std::optional<double> (*value)(const ScoreFigures& score);  ///< nullopt where the score lacks it
};

/// ATE, Error_x, Error_y, relations, in this order. The first one that a world has is its main metric.
const std::vector<Metric>& all_metrics();

/// The values of one metric for a contestant on a world over the seeds. A run that failed counts as an infinite error.
struct Summary {
    std::size_t world = 0;
    std::size_t contestant = 0;
    std::size_t metric = 0;      ///< position in all_metrics()
    std::vector<double> values;  ///< one for each seed, in the order of the seeds
    std::size_t failed = 0;
    std::optional<PairedTest> against_baseline;  ///< paired over seeds; empty for the baseline itself
    double holm_p_value = 1.0;                   ///< corrected over all tests of this metric (Holm)
};

/// The summaries, ordered by metric, then by world, then by contestant. A metric that no run of a world has is left out
/// for that world.
std::vector<Summary> summaries_of(const Experiment& experiment, const std::vector<Cell>& cells,
                                  const std::vector<CellResult>& results);

/// Returns the summary of that world and contestant for the world's main metric, or null if no run of the world was
/// scored.
const Summary* main_summary(const std::vector<Summary>& summaries, std::size_t world, std::size_t contestant);

}  // namespace ddtool::compare

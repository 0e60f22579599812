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
    std::optional<double> (*value)(const ScoreFigures& score);  ///< nullopt where the score has none
};

/// ATE, Error_x, Error_y, relations: the first that a world has is its main one.
const std::vector<Metric>& all_metrics();

/// How a contestant does on a world over the seeds. A run that failed counts as an infinite error.
struct Summary {
    std::size_t world = 0;
    std::size_t contestant = 0;
    std::size_t metric = 0;      ///< position in all_metrics()
    std::vector<double> values;  ///< one a seed, in their order
    std::size_t failed = 0;
    std::optional<PairedTest> against_baseline;  ///< paired over seeds; none for the baseline itself
    double holm_p_value = 1.0;                   ///< over all tests of this metric
};

/// World by world, then contestant by contestant; metric by metric, those only that some run of the world has.
std::vector<Summary> summaries_of(const Experiment& experiment, const std::vector<Cell>& cells,
                                  const std::vector<CellResult>& results);

/// The summary of that world and contestant for the world's main metric; null where no run of the world was scored.
const Summary* main_summary(const std::vector<Summary>& summaries, std::size_t world, std::size_t contestant);

}  // namespace ddtool::compare

#pragma once

#include <memory>
#include <string>
#include <vector>

#include "scores/absolute_error.hpp"
#include "study/compare/result_store.hpp"
#include "study/compare/summary.hpp"

namespace ddtool::compare {

/// The estimate of one contestant for the run that is shown, aligned with the true trajectory if there is one.
struct ShownEstimate {
    std::string contestant;
    std::size_t colour = 0;           ///< position of the contestant in the experiment
    Trajectory trajectory;            ///< world_from_robot
    std::optional<AteResult> errors;  ///< empty without a true trajectory

    /// Returns the contestant's name and its ATE (absolute trajectory error).
    [[nodiscard]] std::string title() const;
};

/// All contestants on one run of a world, that of its median seed. Contestants that failed are left out.
struct ShownRun {
    std::string world;
    std::uint64_t seed = 0;
    std::shared_ptr<const DataSource> data;
    Trajectory truth;  ///< empty where the data has none
    std::vector<ShownEstimate> estimates;
};

/// Reads what is shown from the store; `seed` is a position in the experiment's seeds. Throws Error for results that
/// cannot be read.
ShownRun shown_run(const Experiment& experiment, const std::vector<Cell>& cells, const std::vector<CellResult>& results,
                   const ResultStore& store, std::size_t world, std::size_t seed);

/// Returns the position of the seed that represents all seeds in the pictures of a world, so that every contestant is
/// shown on the same run: the lower median of the seeds, ordered by the product of the contestants' main errors. A run
/// that failed counts as a very large error.
std::size_t median_seed(const Experiment& experiment, const std::vector<Summary>& summaries, std::size_t world);

}  // namespace ddtool::compare

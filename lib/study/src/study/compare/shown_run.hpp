#pragma once

#include <memory>
#include <string>
#include <vector>

#include "scores/absolute_error.hpp"
#include "study/compare/result_store.hpp"
#include "study/compare/summary.hpp"

namespace ddtool::compare {

/// What one contestant made of the run that is shown, laid onto the truth where there is one.
struct ShownEstimate {
    std::string contestant;
    std::size_t colour = 0;           ///< position of the contestant in the experiment
    Trajectory trajectory;            ///< world_from_robot
    std::optional<AteResult> errors;  ///< none without a true trajectory

    /// The contestant's name and its ATE.
    [[nodiscard]] std::string title() const;
};

/// All contestants on the run of a world's median seed; those that failed are left out.
struct ShownRun {
    std::string world;
    std::uint64_t seed = 0;
    std::shared_ptr<const DataSource> data;
    Trajectory truth;  ///< empty where the data has none
    std::vector<ShownEstimate> estimates;
};

/// Throws Error for results that cannot be read.
ShownRun shown_run(const Experiment& experiment, const std::vector<Cell>& cells, const std::vector<CellResult>& results,
                   const ResultStore& store, std::size_t world, std::size_t seed);

/// The seed (its position) that stands for all in pictures of a world: the lower median of the product of the
/// contestants' main errors, so that every contestant is shown on the same run. Runs that failed come last.
std::size_t median_seed(const Experiment& experiment, const std::vector<Summary>& summaries, std::size_t world);

}  // namespace ddtool::compare

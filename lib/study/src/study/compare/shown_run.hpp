#pragma once

#include <memory>
#include <string>
#include <vector>

#include "scores/absolute_error.hpp"
#include "study/compare/result_store.hpp"
#include "study/compare/side_by_side.hpp"
#include "study/compare/summary.hpp"

namespace ddtool::compare {

/// What one method made of the run that is shown, laid onto the truth where there is one.
struct ShownEstimate {
    std::string method;
    std::size_t colour = 0;           ///< position of the method in the experiment
    Trajectory trajectory;            ///< world_from_robot
    std::optional<AteResult> errors;  ///< none without a true trajectory

    /// The method's name and its ATE.
    [[nodiscard]] std::string title() const;
};

/// All methods on the run of a world's median seed; those that failed are left out.
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

/// Of all its trajectories, with a margin.
Extent extent_of(const ShownRun& run);

}  // namespace ddtool::compare

#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "ddtool/base/thread_pool.hpp"
#include "study/compare/result_store.hpp"

namespace ddtool::compare {

struct RunOutcome {
    std::vector<CellResult> results;  ///< one for each cell
    std::size_t computed = 0;         ///< cells that were run, including those that failed
};

/// Gives every cell a result: the stored one if there is one, or else one from running the cell, as jobs::run() does.
/// `program` names the build of ddtool that computes.
RunOutcome run_cells(const Experiment& experiment, const std::vector<Cell>& cells, ResultStore& store,
                     ThreadPool& threads, const std::string& program);

}  // namespace ddtool::compare

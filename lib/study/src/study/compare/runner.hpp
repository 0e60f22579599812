#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "ddtool/base/thread_pool.hpp"
#include "study/compare/result_store.hpp"

namespace ddtool::compare {

struct RunOutcome {
    std::vector<CellResult> results;  ///< one a cell
    std::size_t computed = 0;         ///< cells that were run, failed ones too
};

/// Gives every cell a result: from the store where it is there, else by running it, as jobs::run() does. `program`
/// names the build that computes.
RunOutcome run_cells(const Experiment& experiment, const std::vector<Cell>& cells, ResultStore& store,
                     ThreadPool& threads, const std::string& program);

}  // namespace ddtool::compare

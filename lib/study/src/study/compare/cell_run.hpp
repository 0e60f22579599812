#pragma once

#include <functional>
#include <string>

#include "study/compare/result_store.hpp"

namespace ddtool::compare {

/// Runs one cell from the first frame to the last, scores it and saves it. on_progress gets the share done, 0..1.
/// Throws Error for what keeps the cell from being scored.
CellResult run_cell(const Experiment& experiment, const Cell& cell, ResultStore& store, const std::string& program,
                    const std::function<void(double)>& on_progress);

}  // namespace ddtool::compare

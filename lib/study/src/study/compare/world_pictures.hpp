#pragma once

#include <filesystem>
#include <vector>

#include "ddtool/base/thread_pool.hpp"
#include "study/compare/report.hpp"
#include "study/compare/result_store.hpp"

namespace ddtool::compare {

/// Draws, for every world that has results, the run of its median seed into folder/pictures: trajectories side by side
/// over the truth, maps side by side, errors over time. A world in which drawing fails is left out with a warning.
std::vector<Picture> draw_worlds(const std::filesystem::path& folder, const Experiment& experiment,
                                 const std::vector<Cell>& cells, const std::vector<CellResult>& results,
                                 const ResultStore& store, ThreadPool& threads);

}  // namespace ddtool::compare

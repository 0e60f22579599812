#pragma once

#include <cstddef>
#include <vector>

#include "study/compare/summary.hpp"

namespace ddtool::compare {

/// The seed (its position) that stands for all in pictures of a world: the lower median of the product of the methods'
/// main errors, so that every method is shown on the same run. Runs that failed come last.
std::size_t median_seed(const Experiment& experiment, const std::vector<Summary>& summaries, std::size_t world);

}  // namespace ddtool::compare

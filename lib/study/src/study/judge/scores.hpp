#pragma once

#include <string>
#include <vector>

#include "dataset/dataset.hpp"
#include "study/judge/swarm_scorer.hpp"

namespace ddtool::detection {

/// The scores of those samples, with progress under the name `what`.
std::vector<double> scores_of(const dataset::Dataset& data, const std::vector<std::size_t>& samples,
                              const SwarmScorer& scorer, const std::string& what);

}  // namespace ddtool::detection

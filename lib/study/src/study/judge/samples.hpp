#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "dataset/dataset.hpp"
#include "dataset/grouping.hpp"
#include "study/judge/detector.hpp"

namespace ddtool::judge {

/// Positions of samples in a data set, and whether each is labelled degenerate.
struct LabelledSamples {
    std::vector<std::size_t> indices;
    std::vector<bool> degenerate;
};

LabelledSamples labelled_samples(const dataset::Dataset& data, dataset::LabelRule label, dataset::Split split,
                                 dataset::Part part);

/// Positions in a list of samples, group by group in order.
using Groups = std::map<dataset::GroupKey, std::vector<std::size_t>>;

Groups grouped(const dataset::Dataset& data, const LabelledSamples& samples, const dataset::Grouping& grouping);

/// Returns the scores of those samples and shows the progress under the name `what`.
std::vector<double> scores_of(const dataset::Dataset& data, const std::vector<std::size_t>& samples,
                              const SwarmScorer& scorer, const std::string& what);

}  // namespace ddtool::judge

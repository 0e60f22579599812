#pragma once

#include <map>
#include <vector>

#include "dataset/grouping.hpp"
#include "scores/confusion.hpp"
#include "study/judge/labelled_samples.hpp"

namespace ddtool::detection {

/// Positions in a list of samples, group by group in order.
using Groups = std::map<dataset::GroupKey, std::vector<std::size_t>>;

Groups grouped(const dataset::Dataset& data, const LabelledSamples& samples, const dataset::Grouping& grouping);

}  // namespace ddtool::detection

#pragma once

#include <vector>

#include "dataset/dataset.hpp"
#include "study/judge/detector.hpp"

namespace ddtool::judge {

/// What needs no network (docs/evaluation.md): thresholds on one number of a swarm, and a logistic regression on the
/// covariances of both swarms. Side and value of the thresholds are those that are most accurate on the part train of
/// the split, nothing else is looked at. Where that part has no sample of one of the classes, thresholds are NaN and
/// scores are the plain numbers; the regression is left out.
std::vector<Detector> fitted_rules(const dataset::Dataset& data, dataset::LabelRule label, dataset::Split split);

}  // namespace ddtool::judge

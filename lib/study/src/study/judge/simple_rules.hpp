#pragma once

#include <vector>

#include "dataset/dataset.hpp"
#include "study/judge/detector.hpp"

namespace ddtool::judge {

/// Fits the detectors that need no network (docs/evaluation.md): thresholds on one number of a swarm, and a logistic
/// regression on the covariances of both swarms. Each threshold has the side and value that are most accurate on the
/// split's train part; no other samples are used. If that part has no sample of one of the classes, thresholds are NaN,
/// scores are the plain numbers, and the regression is left out.
std::vector<Detector> fitted_rules(const dataset::Dataset& data, dataset::LabelRule label, dataset::Split split);

}  // namespace ddtool::judge

#pragma once

#include <memory>

#include "ddtool/network/degree_model.hpp"
#include "study/judge/detector.hpp"

namespace ddtool::judge {

/// Combines a trained network with a renderer of the images that it was trained on: it maps swarms to degrees, many
/// images at once. The filter uses network_detector() instead. Not thread-safe: call it from one thread at a
/// time, also counting its copies, which share the network. Throws UsageError if the network's image settings make no
/// sense.
SwarmScorer scorer_of(std::shared_ptr<DegreeModel> model);

/// The same scorer together with the origin of the network. Networks whose descriptions differ only in seed, metrics
/// and temperature form one family.
Detector detector_of(const std::shared_ptr<DegreeModel>& model);

}  // namespace ddtool::judge

#pragma once

#include <memory>

#include "ddtool/network/degree_model.hpp"
#include "study/judge/detector.hpp"

namespace ddtool::judge {

/// A trained network with the renderer of the images it knows: from swarms to degrees, many images at once. For the
/// filter: native::network_detector(). One thread at a time; copies share the network. Throws UsageError where the
/// network's image settings make no sense.
SwarmScorer scorer_of(std::shared_ptr<native::DegreeModel> model);

/// The same with where the network comes from. Networks whose descriptions differ in seed, metrics and temperature
/// alone are one family.
Detector detector_of(const std::shared_ptr<native::DegreeModel>& model);

}  // namespace ddtool::judge

#pragma once

#include <memory>

#include "ddtool/network/degree_model.hpp"
#include "ddtool/swarm/degeneracy_detector.hpp"

namespace ddtool {

/// A detector that draws the filter's swarm in the way of the network's training images, runs the network on it and
/// rounds its degree to thousandths.
/// Copies share the network, so use them all from one thread at a time.
DegeneracyDetector network_detector(std::shared_ptr<DegreeModel> model);

}  // namespace ddtool

#pragma once

#include <memory>

#include "ddtool/network/degree_model.hpp"
#include "ddtool/swarm/degeneracy_detector.hpp"

namespace ddtool::native {

/// A network that looks at the filter's swarm, drawn as the images it was trained on. Copies share the network.
DegeneracyDetector network_detector(std::shared_ptr<DegreeModel> model);

}  // namespace ddtool::native

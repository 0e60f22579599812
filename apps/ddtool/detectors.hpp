#pragma once

#include <string>

#include "ddtool/methods/detector_table.hpp"
#include "ddtool/network/image_settings.hpp"

namespace ddtool {

/// Every detector that the commands know: those of the library, and TorchScript files, for which LibTorch's program
/// takes over (train::engine).
DetectorTable all_detectors();

/// How the detector sees a swarm: the images of its network, for a rule those of the network that is carried inside.
ImageSettings image_seen_by(const std::string& detector);

}  // namespace ddtool

#pragma once

#include <string>

#include "ddtool/methods/detector_table.hpp"
#include "ddtool/network/image_settings.hpp"

namespace ddtool {

/// Every detector that the commands know: those of the library, and TorchScript files. ddtool hands the latter over to
/// the program that is linked with LibTorch (train::engine).
DetectorTable all_detectors();

/// How the detector sees a swarm. For a network these are the settings of its images; for a rule, those of the shipped
/// network.
ImageSettings image_seen_by(const std::string& detector);

}  // namespace ddtool

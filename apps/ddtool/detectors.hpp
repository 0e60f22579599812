#pragma once

#include "slam/detector_table.hpp"

namespace ddtool {

/// Every detector that the commands know: those of the library, and TorchScript files, for which LibTorch's program
/// takes over (learning::engine).
DetectorTable all_detectors();

}  // namespace ddtool

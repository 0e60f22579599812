#pragma once

#include "train/engine.hpp"

namespace ddtool {

/// The engine of this build's LibTorch.
const learning::Engine& torch_engine();

}  // namespace ddtool

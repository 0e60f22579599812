#pragma once

#include "train/engine.hpp"

namespace ddtool::train_torch {

/// The engine of this build's LibTorch.
const train::Engine& torch_engine();

}  // namespace ddtool::train_torch

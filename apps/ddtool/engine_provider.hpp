#pragma once

#include "train/engine.hpp"

namespace ddtool {

/// Where this program has its engine: in itself (ddtool-torch), or in that one, as which it then starts anew (ddtool).
const train::Engine& provide_engine();

}  // namespace ddtool

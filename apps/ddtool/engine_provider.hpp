#pragma once

#include "train/engine.hpp"

namespace ddtool {

/// The training engine of this program. ddtool-torch contains it. ddtool does not: it replaces itself by ddtool-torch,
/// with the same arguments.
const train::Engine& provide_engine();

}  // namespace ddtool

#pragma once

#include <string>

#include "ddtool/system/settings.hpp"
#include "sim/simulation.hpp"

namespace ddtool::sim {

/// Every setting of a simulation with its default: the keys a configuration may have. In `lidar` and `odometry` the
/// `preset` names where the values come from, and null leaves a value to it.
Json default_simulation_json();

/// The defaults for many simulations at once, whose worlds and seeds come from lists.
Json common_simulation_json();

/// The world is named beside the settings, as `world`; see load_world(). Throws UsageError naming the key for an
/// unknown preset or a value that makes no sense.
SimulationSettings simulation_from_json(const Json& json);

}  // namespace ddtool::sim

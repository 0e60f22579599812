#pragma once

#include <string>
#include <vector>

#include "sim/simulation.hpp"
#include "system/setting_rows.hpp"

namespace ddtool::sim {

/// What is known of each setting of a simulation, in the order of their JSON.
std::vector<Setting> simulation_setting_list();

/// Every setting of a simulation with its default: the keys that a configuration may have. In `lidar` and `odometry`,
/// `preset` names the preset from which the values come; a value that is null is the preset's.
Json default_simulation_json();

/// The same defaults for commands that run many simulations, without world and seed, which come from the lists of these
/// commands, and without further lidars and the inertial sensor, which only a log has.
Json common_simulation_json();

/// What is known of these.
std::vector<Setting> common_simulation_setting_list();

/// The world is named beside the settings, as `world`; see load_world(). Throws UsageError naming the key for an
/// unknown preset or a value that makes no sense, after `path` where that is not empty.
SimulationSettings simulation_from_json(const Json& json, const std::string& path = "");

}  // namespace ddtool::sim

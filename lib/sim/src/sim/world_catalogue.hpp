#pragma once

#include <string>
#include <vector>

#include "sim/world.hpp"

namespace ddtool::sim {

/// The world of a name: a built-in one (`s2`), a drawn one (`random:office:17`) or a file (`PATH.json`); any of them
/// with
/// `-textured` behind it, see texture.hpp. Throws UsageError for an unknown name or a bad file.
World load_world(const std::string& name);

struct WorldEntry {
    std::string name;
    std::string description;
};

/// What load_world() knows by name.
std::vector<WorldEntry> list_worlds();

}  // namespace ddtool::sim

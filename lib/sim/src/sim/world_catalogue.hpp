#pragma once

#include <string>
#include <vector>

#include "sim/world.hpp"

namespace ddtool::sim {

/// Loads a world by name: a built-in one (`s2`), a random one (`random:office:17`) or a file (`PATH.json`). Any of them
/// may be followed by `-textured`, see texture.hpp. Throws UsageError for an unknown name or an invalid file.
World load_world(const std::string& name);

struct WorldEntry {
    std::string name;
    std::string description;
};

/// The names that load_world() knows, except files.
std::vector<WorldEntry> list_worlds();

}  // namespace ddtool::sim

#pragma once

#include <filesystem>
#include <fstream>
#include <string>

#include "ddtool/system/settings.hpp"

namespace ddtool::test {

/// A room of 4 x 4 m with a route of one metre, so that a simulated run takes milliseconds.
inline std::string write_tiny_world(const std::filesystem::path& file, double far_wall_m = 2.0) {
    const Json world{{"name", "tiny"},
                     {"description", "a room"},
                     {"start", {-0.5, 0.0, 0.0}},
                     {"way_points", {{0.5, 0.0}}},
                     {"walls", {{{-2, -2}, {far_wall_m, -2}, {2, 2}, {-2, 2}, {-2, -2}}}}};
    std::ofstream(file) << world;
    return file.string();
}

}  // namespace ddtool::test

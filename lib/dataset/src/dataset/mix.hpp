#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "ddtool/base/random.hpp"
#include "ddtool/system/settings.hpp"

namespace ddtool::dataset {

/// How far the robot moves between two updates of the filter.
struct UpdateDistance {
    double distance_m = 0.0;
    double turn_rad = 0.0;
};

/// The values in which the runs of an item may differ. Each run draws one value from each list. If a list is empty, the
/// setting is not changed.
struct Mix {
    std::vector<std::uint64_t> particles;
    std::vector<std::string> lidars;    ///< presets
    std::vector<std::string> odometry;  ///< presets
    std::vector<UpdateDistance> update_distances;
    std::vector<std::string> methods;  ///< of the filter
};

/// Throws UsageError naming `where` and the key if an item of a list is of another kind.
Mix mix_from_json(const Json& json, const std::string& where);

/// The values that one run drew.
struct Variant {
    std::optional<std::uint64_t> particles;
    std::optional<std::string> lidar;
    std::optional<std::string> odometry;
    std::optional<UpdateDistance> update_distance;
    std::optional<std::string> method;
};

/// Draws one value from each list. All entries are equally likely, so that a value given twice is drawn twice as often.
Variant draw_variant(const Mix& mix, RandomStream random);

}  // namespace ddtool::dataset

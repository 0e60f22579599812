#pragma once

#include <string>

#include "ddtool/base/random.hpp"
#include "ddtool/system/settings.hpp"

namespace ddtool::dataset {

/// What one run draws from the mix: changes to the settings of the item. Empty where the mix leaves them alone.
struct Variant {
    Json filter = Json::object();
    Json lidar = Json::object();
    Json odometry = Json::object();
};

/// One of each list of item.mix, all equally likely, so that a value given twice comes twice as often. Throws
/// UsageError naming `where` and the key for a list of something else.
Variant draw_variant(const Json& item, RandomStream random, const std::string& where);

}  // namespace ddtool::dataset

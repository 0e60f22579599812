#pragma once

#include "base/json_struct.hpp"
#include "geometry/pose2.hpp"

namespace ddtool {

DDTOOL_JSON_STRUCT(Pose2, x_m, y_m, theta_rad)

}  // namespace ddtool

#pragma once

#include "ddtool/robot/pose2.hpp"
#include "ddtool/system/json_struct.hpp"

namespace ddtool {

DDTOOL_JSON_STRUCT(Pose2, x_m, y_m, theta_rad)

}  // namespace ddtool

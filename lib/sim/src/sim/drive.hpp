#pragma once

#include "ddtool/robot/trajectory.hpp"
#include "sim/world.hpp"

namespace ddtool::sim {

/// Limits of a differential drive and how it follows a route.
struct DriveSettings {
    double speed_m_per_s = 1.0;
    double acceleration_m_per_s2 = 0.8;
    double turn_rate_rad_per_s = 1.0;
    double turn_acceleration_rad_per_s2 = 2.0;
    double turn_in_place_above_rad = 0.6;  ///< with a larger heading error the robot turns in place
    double lookahead_m = 0.6;              ///< steers for the point this far ahead on the line between way points
};

/// The true poses (world_from_robot) along the route, from standstill to standstill, every step_ns from start_ns:
/// unicycle motion that is controlled once per step, pure pursuit of the line between way points (Coulter 1992),
/// braking for the next way point. Throws UsageError for settings that are not above 0, and if a way point is missed by
/// 0.5 m.
Trajectory drive(const Route& route, const DriveSettings& settings, std::int64_t start_ns, std::int64_t step_ns);

}  // namespace ddtool::sim

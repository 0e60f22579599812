#pragma once

#include <cstdint>
#include <vector>

#include "ddtool/robot/trajectory.hpp"

namespace ddtool::sim {

/// A gyro about the robot's vertical axis.
struct ImuSettings {
    double rate_hz = 0.0;                ///< 0: there is none
    double bias_sd_rad_per_s = 0.005;    ///< what it reads at rest, standard deviation over runs
    double noise_rad_per_sqrt_s = 1e-4;  ///< standard deviation of the turn that it measures in a second
};

struct StampedTurnRate {
    std::int64_t stamp_ns = 0;
    double rad_per_s = 0.0;
};

/// What the gyro reads along a drive; empty without one. A reading is the true mean rate since the reading before, and
/// has the stamp of the middle of that time.
/// \param truth world_from_robot, with rising stamps
std::vector<StampedTurnRate> simulate_gyro(const Trajectory& truth, const ImuSettings& settings, std::uint64_t seed);

}  // namespace ddtool::sim

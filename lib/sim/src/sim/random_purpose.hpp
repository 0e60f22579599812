#pragma once

#include <cstdint>

namespace ddtool::sim {

/// The second key of the simulator's random streams, after the seed. Every purpose has a key of its own, so that no two
/// purposes share a stream.
enum RandomPurpose : std::uint64_t {
    odometry_run = 1,   ///< the constants of one run: scale error, gyro bias
    odometry_step = 2,  ///< third key: the step
    scan_noise = 3,     ///< third key: the scan; fourth: the lidar, if it is not the first
    texture_layout = 4,
    random_layout = 5,
    imu_run = 6,   ///< the bias of the gyro
    imu_step = 7,  ///< third key: the step
};

}  // namespace ddtool::sim

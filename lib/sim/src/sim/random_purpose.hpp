#pragma once

#include <cstdint>

namespace ddtool::sim {

/// Second key of the simulator's random streams, after the seed: no two uses of chance share a stream.
enum RandomPurpose : std::uint64_t {
    odometry_run = 1,   ///< what one run of the odometry keeps: scale error, gyro bias
    odometry_step = 2,  ///< third key: the step
    scan_noise = 3,     ///< third key: the scan
    texture_layout = 4,
    random_layout = 5,
};

}  // namespace ddtool::sim

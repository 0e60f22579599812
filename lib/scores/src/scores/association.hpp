#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "ddtool/robot/trajectory.hpp"

namespace ddtool {

/// How far apart two stamps may be and still mean the same moment: evo's default.
inline constexpr double default_max_time_difference_s = 0.01;

/// Finds poses by time in a trajectory whose stamps need not rise. The trajectory's own order stays as it is.
class StampIndex {
public:
    explicit StampIndex(const Trajectory& trajectory);

    /// Position in the trajectory of the pose nearest in time, none farther away than max_time_difference_s. Of equal
    /// stamps the first in the trajectory; of two equally near, the earlier.
    [[nodiscard]] std::optional<std::size_t> nearest(std::int64_t stamp_ns, double max_time_difference_s) const;

private:
    std::vector<std::pair<std::int64_t, std::size_t>> positions_by_stamp_;
};

/// Estimate and reference at the same moment, each in its own world frame.
struct PosePair {
    std::int64_t stamp_ns = 0;  ///< of the estimate
    Pose2 estimate;
    Pose2 reference;
};

/// Pairs two trajectories as evo's associate_trajectories does: every pose of the shorter one (the estimate, when both
/// are equally long) takes the nearest of the longer one within the tolerance. In the order of the shorter one.
std::vector<PosePair> associate(const Trajectory& estimate, const Trajectory& reference, double max_time_difference_s);

}  // namespace ddtool

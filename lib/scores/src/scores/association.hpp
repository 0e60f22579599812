#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "ddtool/robot/trajectory.hpp"

namespace ddtool {

/// The largest difference in seconds of two stamps that still count as the same moment: evo's default.
inline constexpr double default_max_time_difference_s = 0.01;

/// Finds poses by time in a trajectory whose stamps need not rise. The trajectory itself is not reordered.
class StampIndex {
public:
    explicit StampIndex(const Trajectory& trajectory);

    /// The index in the trajectory of the pose that is nearest in time; nullopt if none is within
    /// max_time_difference_s. Of poses with equal stamps it is the first one in the trajectory, and of two that are
    /// equally near the earlier one.
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

/// Pairs two trajectories as evo's associate_trajectories does: every pose of the shorter one (the estimate, if both
/// are equally long) is paired with the nearest pose of the longer one within the tolerance. The pairs are in the order
/// of the shorter trajectory.
std::vector<PosePair> associate(const Trajectory& estimate, const Trajectory& reference, double max_time_difference_s);

}  // namespace ddtool

#pragma once

#include <vector>

#include "scores/alignment.hpp"
#include "scores/error_statistics.hpp"

namespace ddtool {

struct AteOptions {
    Alignment alignment = Alignment::se2;
    double max_time_difference_s = default_max_time_difference_s;
};

struct AteResult {
    Pose2 reference_from_estimate;  ///< the alignment
    std::vector<PosePair> pairs;    ///< after the alignment: both poses are in the reference's frame
    std::vector<double> errors_m;   ///< distance between the positions, one per pair
    ErrorStatistics translation_m;  ///< its rmse is what papers call the ATE
    ErrorStatistics error_x_m;      ///< |x - x_reference|; the paper's Error_x is the mean
    ErrorStatistics error_y_m;
};

/// Absolute trajectory error, translation part (Sturm et al. 2012; evo's APE). The two trajectories may have different
/// world frames. Throws Error if no pose of the estimate has a pose of the reference at the same time.
AteResult absolute_trajectory_error(const Trajectory& estimate, const Trajectory& reference,
                                    const AteOptions& options = {});

}  // namespace ddtool

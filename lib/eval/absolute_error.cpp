#include "eval/absolute_error.hpp"

#include <cmath>

namespace ddtool {

AteResult absolute_trajectory_error(const Trajectory& estimate, const Trajectory& reference,
                                    const AteOptions& options) {
    AteResult result;
    result.pairs = associate(estimate, reference, options.max_time_difference_s);
    result.reference_from_estimate = reference_from_estimate(result.pairs, options.alignment);
    std::vector<double> errors_x_m;
    std::vector<double> errors_y_m;
    for (PosePair& pair : result.pairs) {
        pair.estimate = result.reference_from_estimate * pair.estimate;
        errors_x_m.push_back(std::abs(pair.estimate.x_m - pair.reference.x_m));
        errors_y_m.push_back(std::abs(pair.estimate.y_m - pair.reference.y_m));
        result.errors_m.push_back(distance_m(pair.estimate, pair.reference));
    }
    result.translation_m = error_statistics(result.errors_m);
    result.error_x_m = error_statistics(errors_x_m);
    result.error_y_m = error_statistics(errors_y_m);
    return result;
}

}  // namespace ddtool

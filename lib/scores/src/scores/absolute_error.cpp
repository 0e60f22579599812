#include "scores/absolute_error.hpp"

#include <array>
#include <cmath>
#include <cstdio>
#include <string>

#include "ddtool/base/error.hpp"

namespace ddtool {
namespace {

std::string tolerance_text(double tolerance_s) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%g s", tolerance_s);
    return text.data();
}

std::string begin_text(const Trajectory& trajectory) {
    return trajectory.empty() ? "is empty"
                              : "begins at " + std::to_string(trajectory.front().stamp_ns / 1'000'000'000) + " s";
}

}  // namespace

AteResult absolute_trajectory_error(const Trajectory& estimate, const Trajectory& reference,
                                    const AteOptions& options) {
    AteResult result;
    result.pairs = associate(estimate, reference, options.max_time_difference_s);
    if (result.pairs.empty()) {
        throw Error("no pose of the estimate is within " + tolerance_text(options.max_time_difference_s) +
                    " of one of the reference; the estimate " + begin_text(estimate) + ", the reference " +
                    begin_text(reference));
    }
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

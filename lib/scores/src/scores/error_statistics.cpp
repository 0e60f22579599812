#include "scores/error_statistics.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "scores/statistics.hpp"

namespace ddtool {

ErrorStatistics error_statistics(std::span<const double> errors) {
    if (errors.empty()) {
        const double none = std::numeric_limits<double>::quiet_NaN();
        return {0, none, none, none, none, none, none};
    }
    const auto count = static_cast<double>(errors.size());
    const double mean = std::accumulate(errors.begin(), errors.end(), 0.0) / count;
    double squares = 0.0;
    double squares_about_mean = 0.0;
    for (const double error : errors) {
        squares += error * error;
        squares_about_mean += (error - mean) * (error - mean);
    }
    const auto [min, max] = std::minmax_element(errors.begin(), errors.end());
    return {.count = errors.size(),
            .rmse = std::sqrt(squares / count),
            .mean = mean,
            .median = median(errors),
            .std = std::sqrt(squares_about_mean / count),
            .min = *min,
            .max = *max};
}

void to_json(Json& json, const ErrorStatistics& statistics) {
    json = {{"count", statistics.count},   {"rmse", statistics.rmse}, {"mean", statistics.mean},
            {"median", statistics.median}, {"std", statistics.std},   {"min", statistics.min},
            {"max", statistics.max}};
}

}  // namespace ddtool

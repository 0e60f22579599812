#include "scores/error_statistics.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "scores/statistics.hpp"

namespace ddtool {
namespace {

constexpr double not_counted = std::numeric_limits<double>::quiet_NaN();

double number_in(const Json& json, const char* key) {
    const Json& value = json.at(key);
    return value.is_null() ? not_counted : value.get<double>();
}

}  // namespace

ErrorStatistics error_statistics(std::span<const double> errors) {
    if (errors.empty()) {
        return {0, not_counted, not_counted, not_counted, not_counted, not_counted, not_counted};
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

void from_json(const Json& json, ErrorStatistics& statistics) {
    statistics = {.count = json.at("count"),
                  .rmse = number_in(json, "rmse"),
                  .mean = number_in(json, "mean"),
                  .median = number_in(json, "median"),
                  .std = number_in(json, "std"),
                  .min = number_in(json, "min"),
                  .max = number_in(json, "max")};
}

}  // namespace ddtool

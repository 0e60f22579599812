#pragma once

#include <cstddef>
#include <span>

#include "ddtool/system/settings.hpp"

namespace ddtool {

/// Summary statistics of errors, as evo defines them, in the unit of the errors. All are NaN if there are no errors.
struct ErrorStatistics {
    std::size_t count = 0;
    double rmse = 0.0;
    double mean = 0.0;
    double median = 0.0;  ///< mean of the middle two for an even count
    double std = 0.0;     ///< about the mean, divided by the count
    double min = 0.0;
    double max = 0.0;
};

ErrorStatistics error_statistics(std::span<const double> errors);

void to_json(Json& json, const ErrorStatistics& statistics);
/// NaN, which JSON writes as null, is read back as such.
void from_json(const Json& json, ErrorStatistics& statistics);

}  // namespace ddtool

#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace ddtool {

/// The samples for which the predicted probability of being positive lies between low and high.
struct ReliabilityBin {
    double low = 0.0;
    double high = 0.0;
    std::size_t count = 0;
    double mean_probability = 0.0;  ///< mean predicted probability; NaN for an empty bin
    double positive_share = 0.0;    ///< share of samples that are positive; NaN for an empty bin
};

inline constexpr std::size_t reliability_bin_count = 15;

/// Bins of equal width over 0..1. The upper edge belongs to its bin; the first bin contains both of its edges. Both
/// spans must have the same length.
std::vector<ReliabilityBin> reliability(std::span<const double> probabilities, const std::vector<bool>& positive,
                                        std::size_t bins = reliability_bin_count);

/// Expected calibration error: mean of |positive_share - mean_probability| over the bins, weighted by their counts
/// (Naeini et al. 2015; Guo et al. 2017, eq. 3, here of the positive class). NaN for no samples.
double expected_calibration_error(std::span<const ReliabilityBin> bins);

/// The probability whose logit is that of `probability` divided by the temperature (Guo et al. 2017, 4.2). 0 and 1 are
/// taken as 1e-9 from the edge.
double at_temperature(double probability, double temperature);

/// The temperature in 0.01..100 at which the probabilities have the smallest negative log-likelihood. It is unique,
/// because that function is convex in 1/temperature. 1 for no samples. Both spans must have the same length.
double fitted_temperature(std::span<const double> probabilities, const std::vector<bool>& positive);

}  // namespace ddtool

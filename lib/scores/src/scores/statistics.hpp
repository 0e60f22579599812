#pragma once

#include <cstddef>
#include <span>

namespace ddtool {

/// The quantile of the values, interpolated linearly between order statistics (definition 7 of Hyndman and Fan 1996,
/// the default of R and NumPy). NaN for no values. Infinite values (runs that failed) are allowed.
/// \param fraction in 0..1: the share of the values that lies below the result
double quantile(std::span<const double> values, double fraction);

double median(std::span<const double> values);

/// Sample mean and standard deviation (divided by the count less one). The mean is NaN for no values, the standard
/// deviation for fewer than two.
struct MeanAndSd {
    double mean = 0.0;
    double sd = 0.0;
};

MeanAndSd mean_and_sd(std::span<const double> values);

/// An interval between two of the values that contains the true median with at least the wanted probability.
struct MedianInterval {
    double low = 0.0;
    double high = 0.0;
    double coverage = 0.0;  ///< exact; below the wanted one if even [min, max] has less (5 values: 0.9375)
};

/// The narrowest symmetric pair of order statistics, exact for any continuous distribution (Conover 1999, 3.2).
/// All NaN, coverage 0, for no values.
MedianInterval median_interval(std::span<const double> values, double wanted_coverage = 0.95);

struct PairedTest {
    std::size_t differing_pairs = 0;
    double median_difference = 0.0;  ///< median of second - first over all pairs
    double p_value = 1.0;            ///< two-sided
};

/// Wilcoxon's signed-rank test of paired samples, e.g. two methods with the same seeds (Wilcoxon 1945). Pairs without
/// difference are dropped, including pairs of two infinite values; tied differences share their mean rank. p is exact:
/// the share of all 2^n sign patterns of the observed ranks that are at least as one-sided as the observed one,
/// doubled. With n pairs it cannot fall below 2^(1-n), so that fewer than six pairs can never reach 0.05. The cost is
/// O(n^3). Both samples must have the same length.
PairedTest wilcoxon_signed_rank(std::span<const double> first, std::span<const double> second);

}  // namespace ddtool

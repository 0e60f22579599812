#pragma once

#include <cstddef>
#include <span>

namespace ddtool {

/// The value below which a fraction 0..1 of the values lies, interpolated linearly between order statistics
/// (definition 7 of Hyndman and Fan 1996, the default of R and NumPy). NaN for no values. Infinite values (a run that
/// failed) take their place in the order.
double quantile(std::span<const double> values, double fraction);

double median(std::span<const double> values);

/// Sample mean and standard deviation (divided by the number less one); NaN where there are too few values.
struct MeanAndSd {
    double mean = 0.0;
    double sd = 0.0;
};

MeanAndSd mean_and_sd(std::span<const double> values);

/// An interval between two of the values that covers the true median with at least the wanted probability.
struct MedianInterval {
    double low = 0.0;
    double high = 0.0;
    double coverage = 0.0;  ///< exact; less than wanted when even the extremes cover too little (5 values: 0.9375)
};

/// The narrowest symmetric pair of order statistics, exact for any continuous distribution (Conover 1999, 3.2).
/// All NaN, coverage 0, for no values.
MedianInterval median_interval(std::span<const double> values, double wanted_coverage = 0.95);

struct PairedTest {
    std::size_t differing_pairs = 0;
    double median_difference = 0.0;  ///< median of second - first over all pairs
    double p_value = 1.0;            ///< two-sided
};

/// Wilcoxon's signed-rank test of paired samples, e.g. two methods over the same seeds (Wilcoxon 1945). Pairs without
/// difference are dropped, two infinite values among them; tied differences share their mean rank. p is exact: the
/// share of all 2^n sign patterns of the observed ranks that are at least as one-sided, doubled. With n pairs it cannot
/// fall below 2^(1-n), so that fewer than six can never reach 0.05. Cost O(n^3). Both samples have the same length.
PairedTest wilcoxon_signed_rank(std::span<const double> first, std::span<const double> second);

}  // namespace ddtool

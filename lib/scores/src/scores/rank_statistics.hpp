#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace ddtool {

/// Twice the rank of each value, beginning with 2. Tied values share their mean rank, which is a whole number when
/// doubled. Values must not be NaN.
std::vector<std::size_t> doubled_ranks(std::span<const double> values);

/// Area under the receiver operating characteristic (ROC): the probability that of a random positive and a random
/// negative sample the positive one has the higher score, where ties count one half (Mann and Whitney 1947; Hanley and
/// McNeil 1982). NaN if one of the classes is empty. A sample with a NaN score is left out. Both spans must have the
/// same length.
double roc_auc(std::span<const double> scores, const std::vector<bool>& positive);

/// A point of the receiver operating characteristic: the rates at one threshold.
struct RocPoint {
    double false_positive_rate = 0.0;
    double true_positive_rate = 0.0;
};

/// The curve from (0, 0) to (1, 1), with one point for every distinct score, highest first. Empty if one of the classes
/// is empty. Scores must not be NaN, and both spans must have the same length.
std::vector<RocPoint> roc_curve(std::span<const double> scores, const std::vector<bool>& positive);

/// Spearman's rank correlation: the linear correlation of the ranks, where ties share their mean rank. NaN for fewer
/// than two pairs, and if all values of one side are equal. A pair with a NaN is left out. Both spans must have the
/// same length.
double rank_correlation(std::span<const double> first, std::span<const double> second);

}  // namespace ddtool

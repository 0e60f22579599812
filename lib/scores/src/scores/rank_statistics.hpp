#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace ddtool {

/// Twice the rank of each value, from 2 up; tied values share their mean rank, which doubled is whole. NaN is not
/// allowed.
std::vector<std::size_t> doubled_ranks(std::span<const double> values);

/// Area under the receiver operating characteristic: the chance that a positive has the higher score of a positive and
/// a negative drawn at random, ties counting one half (Mann and Whitney 1947; Hanley and McNeil 1982). NaN where one of
/// the classes is empty. Both spans have the same length; a pair with a NaN score is left out.
double roc_auc(std::span<const double> scores, const std::vector<bool>& positive);

/// A point of the receiver operating characteristic: what is decided positive at one threshold.
struct RocPoint {
    double false_positive_rate = 0.0;
    double true_positive_rate = 0.0;
};

/// From (0, 0) to (1, 1), a point for every distinct score, highest first. Empty where one of the classes is. Scores
/// are no NaN, both spans have the same length.
std::vector<RocPoint> roc_curve(std::span<const double> scores, const std::vector<bool>& positive);

/// Spearman's rank correlation, the linear correlation of the ranks, ties sharing their mean rank. NaN for fewer than
/// two pairs or where one side is constant. Both spans have the same length; a pair with a NaN is left out.
double rank_correlation(std::span<const double> first, std::span<const double> second);

}  // namespace ddtool

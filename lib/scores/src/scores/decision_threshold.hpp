#pragma once

#include <span>
#include <vector>

namespace ddtool {

/// A threshold for scores: samples on one side of it are decided positive.
struct DecisionThreshold {
    double value = 0.0;
    bool positive_above = true;  ///< false: positive below the threshold
};

/// The threshold, and the side, with which most of these samples are decided correctly. It lies halfway between two
/// scores, or is infinite if one decision for all samples is best. Of equally good thresholds it is the lowest. Scores
/// must not be NaN, and both spans must have the same length.
DecisionThreshold most_accurate_threshold(std::span<const double> scores, const std::vector<bool>& positive);

}  // namespace ddtool

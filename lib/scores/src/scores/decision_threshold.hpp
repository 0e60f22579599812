#pragma once

#include <span>
#include <vector>

namespace ddtool {

/// A cut through scores: those on one side of it are decided positive.
struct DecisionThreshold {
    double value = 0.0;
    bool positive_above = true;  ///< or else below
};

/// The cut that decides most of these samples right, on whichever side; halfway between two scores, or infinite where
/// one decision for all is best. Of equally good ones the lowest. Scores are no NaN, both spans have the same length.
DecisionThreshold most_accurate_threshold(std::span<const double> scores, const std::vector<bool>& positive);

}  // namespace ddtool

#pragma once

#include <span>
#include <vector>

#include "scores/confusion.hpp"
#include "study/judge/detector.hpp"

namespace ddtool::detection {

/// What came of a detector's scores on some samples.
struct Performance {
    std::size_t samples = 0;
    double degenerate_share = 0.0;  ///< of the samples
    Confusion confusion;            ///< empty for a detector without threshold
    double auc = 0.0;
};

Performance performance_of(const Detector& detector, std::span<const double> scores,
                           const std::vector<bool>& degenerate);

}  // namespace ddtool::detection

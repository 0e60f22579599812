#include "study/judge/detector.hpp"

#include <algorithm>
#include <cmath>

#include "scores/rank_statistics.hpp"

namespace ddtool::judge {

Performance performance_of(const Detector& detector, std::span<const double> scores,
                           const std::vector<bool>& degenerate) {
    const auto positives = std::count(degenerate.begin(), degenerate.end(), true);
    return {.samples = scores.size(),
            .degenerate_share = static_cast<double>(positives) / static_cast<double>(scores.size()),
            .confusion =
                std::isnan(detector.threshold) ? Confusion{} : confusion_of(scores, degenerate, detector.threshold),
            .auc = roc_auc(scores, degenerate)};
}

}  // namespace ddtool::judge

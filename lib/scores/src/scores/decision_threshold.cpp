#include "scores/decision_threshold.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <numeric>

namespace ddtool {

DecisionThreshold most_accurate_threshold(std::span<const double> scores, const std::vector<bool>& positive) {
    std::vector<std::size_t> order(scores.size());
    std::iota(order.begin(), order.end(), 0U);
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return scores[a] < scores[b]; });
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const auto count = static_cast<std::int64_t>(scores.size());
    // The number of right decisions if everything above the cut is decided positive. The first cut lies below all
    // scores.
    std::int64_t right = std::count(positive.begin(), positive.end(), true);
    std::int64_t most_right = -1;
    DecisionThreshold best;
    for (std::size_t cut = 0; cut <= order.size(); ++cut) {
        const double below = cut == 0 ? -infinity : scores[order[cut - 1]];
        const double above = cut == order.size() ? infinity : scores[order[cut]];
        if (below < above && std::max(right, count - right) > most_right) {
            most_right = std::max(right, count - right);
            best = {std::midpoint(below, above), right >= count - right};
        }
        if (cut < order.size()) {
            right += positive[order[cut]] ? -1 : 1;
        }
    }
    return best;
}

}  // namespace ddtool

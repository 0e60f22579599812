#pragma once

#include <cstddef>

#include "ddtool/filter/strategies.hpp"

namespace ddtool {

struct CoarseFineSettings {
    double step_m = 0.1;     ///< delta_l
    double turn_rad = 0.05;  ///< delta_a
};

/// Pairs of a coarse and a fine search: one, and one more for every 0.25 of the degree (Fig. system_pipeline).
std::size_t search_count(double degree);

/// The paper's "Global Position Optimization": from the match, steps of delta_l in eight directions and turns of
/// +-delta_a, to the best score, then the same with half of each; all of it search_count() times. What is found counts
/// where it scores higher than the match did.
class CoarseFineSearch : public PoseCorrection {
public:
    explicit CoarseFineSearch(const CoarseFineSettings& settings) : settings_(settings) {}
    ScanMatch correct(const MatchContext& context, const ScanMatch& found) const override;

private:
    CoarseFineSettings settings_;
};

}  // namespace ddtool

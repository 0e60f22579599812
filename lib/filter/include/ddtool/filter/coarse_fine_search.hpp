#pragma once

#include <array>
#include <cstddef>

#include "ddtool/filter/strategies.hpp"

namespace ddtool {

struct CoarseFineSettings {
    double step_m = 0.1;     ///< delta_l, the length of a coarse step
    double turn_rad = 0.05;  ///< delta_a, the angle of a coarse step
};

/// The poses that one step of the search tries: shifted in eight directions, turned both ways.
std::array<Pose2, 10> poses_around(const Pose2& centre, double step_m, double turn_rad);

/// How many pairs of a coarse and a fine search are made: one, and one more for every 0.25 of the degree (the paper's
/// figure system_pipeline). Degrees outside of 0..1 are clamped to it.
std::size_t search_count(double degree);

/// Calls step(step_m, turn_rad) for every search that the degree asks for: coarse, fine, coarse, fine, ...
template <typename Step>
void coarse_to_fine(const CoarseFineSettings& settings, double degree, Step&& step) {
    for (std::size_t pair = 0; pair < search_count(degree); ++pair) {
        step(settings.step_m, settings.turn_rad);
        step(settings.step_m / 2.0, settings.turn_rad / 2.0);
    }
}

/// The paper's "Global Position Optimization". Starting at the pose that scan matching found, a coarse search tries
/// steps of delta_l in eight directions and turns of +-delta_a and moves to the best score; a fine search does the same
/// with half of each. This pair of searches runs search_count() times. The result replaces the match only where its
/// score over all beams is higher than the score of the match.
class CoarseFineSearch : public PoseCorrection {
public:
    explicit CoarseFineSearch(const CoarseFineSettings& settings) : settings_(settings) {}
    ScanMatch correct(const MatchContext& context, const ScanMatch& found) const override;

private:
    CoarseFineSettings settings_;
};

}  // namespace ddtool

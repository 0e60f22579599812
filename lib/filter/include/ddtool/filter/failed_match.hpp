#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "ddtool/filter/coarse_fine_search.hpp"
#include "ddtool/filter/hill_climb.hpp"

namespace ddtool {

/// The paper's strategies for the pose, as GMapping can take them. They act only where a match failed (the paper's
/// figure system_pipeline). GMapping's own test of that is a threshold on the score, minimumScore; the paper scales the
/// score by phi(c) first (eq. pose_es). Each strategy may be missing.
struct FailedMatchSettings {
    /// A match failed where phi(c) times its score, divided by the number of beams, is not above this. In a room, 99 of
    /// 100 matches of GMapping have a higher score, and phi is 1 at c = 0.5: such a match fails only where the detector
    /// answers "degenerate" (docs/anti-degeneracy.md).
    double least_score = 0.85;
    std::optional<CoarseFineSettings> search;  ///< the "global position optimization"
    bool weighs_odometry = false;              ///< lets the odometry's pose win where it has the higher score
};

/// What becomes of the match of a particle at the degree c of degeneracy.
/// `beams`: the number of beams of the scan, without failed ones; those without return count, so that a scan that meets
/// little has a low score, as with GMapping's minimumScore.
/// `predicted`: the particle's pose by the odometry with its noise, to which GMapping returns where a match fails.
/// Returns `found` itself if it did not fail or nothing is better.
[[nodiscard]] HillClimb::Found rescued(const FailedMatchSettings& settings, HillClimb& matcher, const HitMap& map,
                                       std::span<const Point2> ends, std::size_t beams, const HillClimb::Found& found,
                                       const Pose2& predicted, double degree);

}  // namespace ddtool

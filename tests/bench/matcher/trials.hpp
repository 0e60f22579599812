#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "ddtool/filter/rbpf.hpp"
#include "drive_through.hpp"

namespace ddtool::matcher_bench {

struct TrialSettings {
    RbpfSettings filter;
    /// So weak that the scan decides wherever it says anything at all.
    PosePrior prior{.sigma_along_m = 1.0, .sigma_across_m = 1.0, .sigma_turn_rad = 1.0};
    /// Displaced predictions are drawn evenly from the box of this half width about the true pose.
    double displacement_m = 0.05;
    double displacement_rad = 0.03;
    std::uint64_t seed = 1;
};

/// What the matcher does with the scan of one place. The vectors have the axes along (Place::along_rad), across (to the
/// left of it) and heading, in m, m and rad.
struct Trial {
    double way_m = 0.0;
    bool accepted = false;            ///< both matches; see ScanMatch::accepted()
    Eigen::Vector3d first_step;       ///< of the search from the true pose, with a right matcher 0 in the mean
    Eigen::Vector3d error;            ///< of the match from the true pose
    Eigen::Vector3d displacement;     ///< of the displaced prediction
    Eigen::Vector3d error_displaced;  ///< of the match from it
    Eigen::Vector3d bound;            ///< standard deviations: Cramer-Rao bound with the true walls and the prior
    Eigen::Vector3d believed;         ///< standard deviations according to the match's own information and the prior
};

/// Matches the scan of every place with the map of the scans before it, as the filter would at the frontier: the
/// scans enter the map at their true poses, at the filter's distances. There is no trial at the first place.
std::vector<Trial> match_at_frontier(const std::vector<Place>& places, const TrialSettings& settings);

/// Matches the scan of every place with a map that was made of all scans of `mapped` before.
std::vector<Trial> match_in_known_map(const std::vector<Place>& mapped, const std::vector<Place>& places,
                                      const TrialSettings& settings);

/// How much longer the way is in a map of a single hypothesis than in truth, as a share: a filter with one particle
/// and an odometry without error drives through all places, so that only errors of the match and of the drawn
/// predictions remain, and enters each scan at the pose that it believes.
double drift(const std::vector<Place>& places, const TrialSettings& settings);

}  // namespace ddtool::matcher_bench

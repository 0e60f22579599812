#pragma once

#include <vector>

#include "check/kept_scans.hpp"

namespace ddtool::check {

/// How the scans of many pairs agree when they are placed by some path.
struct PairEvidence {
    std::size_t pairs = 0;      ///< that see enough in common to be compared
    double contradicted = 0.0;  ///< share of all compared points that one scan saw and the other saw through
    double p90 = 0.0;           ///< a tenth of the pairs contradict each other more than this
    double bad = 0.0;           ///< share of the pairs that contradict each other in more than `bad_pair` of the points
    /// So much of two scans from healthy logs hardly ever contradicts, people and doors between them included.
    static constexpr double bad_pair = 0.25;
};

/// Compares every scan with the next two.
/// \param poses the robot's pose at each of the scans, by the path that is checked
PairEvidence neighbours(const std::vector<KeptScan>& scans, const std::vector<Pose2>& poses);

/// Compares scans that were taken at places near each other but at different times.
PairEvidence revisits(const std::vector<KeptScan>& scans, const std::vector<Pose2>& poses);

}  // namespace ddtool::check

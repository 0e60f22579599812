#pragma once

#include <span>
#include <string_view>

#include "scores/association.hpp"
#include "scores/error_statistics.hpp"

namespace ddtool {

enum class DeltaUnit { frames, metres, seconds };

/// From "frames", "metres" or "seconds"; throws UsageError otherwise.
DeltaUnit parse_delta_unit(std::string_view name);

/// How far apart the two poses of a motion are.
struct RpeDelta {
    double value = 1.0;  ///< > 0; whole for frames
    DeltaUnit unit = DeltaUnit::frames;
};

struct RpeResult {
    ErrorStatistics translation_m;
    ErrorStatistics rotation_deg;
};

/// Relative pose error (Sturm et al. 2012): the motions from one pose to the next, delta apart, compared between
/// estimate and reference: inverse(reference motion) * estimated motion. The motions follow each other without
/// overlap, as in evo. Metres are path length of the estimate; with metres or seconds the chain begins, as in evo, once
/// the first delta is behind. Alignment makes no difference. Throws UsageError for a delta that is not positive, or not
/// whole for frames.
RpeResult relative_pose_error(std::span<const PosePair> pairs, const RpeDelta& delta = {});

}  // namespace ddtool

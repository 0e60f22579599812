#pragma once

#include <span>
#include <string_view>

#include "scores/association.hpp"
#include "scores/error_statistics.hpp"

namespace ddtool {

enum class DeltaUnit { frames, metres, seconds };

/// The unit named "frames", "metres" or "seconds"; throws UsageError for any other name.
DeltaUnit parse_delta_unit(std::string_view name);

/// How far apart the two poses are whose relative motion is compared.
struct RpeDelta {
    double value = 1.0;  ///< > 0; whole for frames
    DeltaUnit unit = DeltaUnit::frames;
};

struct RpeResult {
    ErrorStatistics translation_m;
    ErrorStatistics rotation_deg;
};

/// Relative pose error (Sturm et al. 2012): the motions from one pose to the pose one delta later are compared between
/// estimate and reference, as inverse(reference motion) * estimated motion. The motions follow each other without
/// overlap, as in evo. Metres are measured along the path of the estimate. With metres and seconds the first motion
/// begins, as in evo, where the first delta has been covered. Alignment does not change the result. Throws UsageError
/// for a delta that is not positive, or not whole for frames.
RpeResult relative_pose_error(std::span<const PosePair> pairs, const RpeDelta& delta = {});

}  // namespace ddtool

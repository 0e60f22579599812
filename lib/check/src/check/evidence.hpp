#pragma once

#include "check/motion_evidence.hpp"
#include "check/scan_pairs.hpp"
#include "check/step_evidence.hpp"
#include "ddtool/system/settings.hpp"

namespace ddtool::check {

/// All that the self-check of a run measured.
struct Evidence {
    std::size_t scans = 0;        ///< that were kept and compared
    std::size_t all_scans = 0;    ///< of the run
    std::size_t blind_scans = 0;  ///< of these, without a single range
    PairEvidence neighbours, revisits;
    PairEvidence odometry_revisits;  ///< of the same scans, placed by the odometry alone
    /// Root of the mean squared distance of the path from the odometry's path, after that was shifted, turned and
    /// scaled to fit.
    double from_odometry_m = 0.0;
    MotionEvidence motion;
    StepEvidence steps;
};

/// The evidence in the form of run.json (docs/formats/results.md).
Json evidence_json(const Evidence& evidence);

}  // namespace ddtool::check

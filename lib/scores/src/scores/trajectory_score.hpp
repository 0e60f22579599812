#pragma once

#include <optional>
#include <vector>

#include "report/table.hpp"
#include "scores/absolute_error.hpp"
#include "scores/relations.hpp"
#include "scores/relative_error.hpp"

namespace ddtool {

struct ScoreOptions {
    AteOptions ate;
    RpeDelta rpe_delta;
};

/// All that can be said of a trajectory with the truth at hand.
struct TrajectoryScore {
    std::optional<AteResult> absolute;  ///< both, where there is a reference trajectory
    std::optional<RpeResult> relative;
    std::optional<RelationErrors> relations;
};

/// Compares with a reference trajectory. Throws Error when the two have no moment in common.
TrajectoryScore score_against(const Trajectory& estimate, const Trajectory& reference,
                              const ScoreOptions& options = {});

/// One row an error: its statistics.
Table score_table(const TrajectoryScore& score);

/// {"ate_m": {"rmse": ...}, "error_x_m", "error_y_m", "rpe_m", "rpe_deg", "reference_from_estimate",
/// "relations_m", "relations_deg", "relations_skipped"}: those that are there.
Json score_json(const TrajectoryScore& score);

}  // namespace ddtool

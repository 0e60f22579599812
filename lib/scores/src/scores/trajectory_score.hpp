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

/// All errors of a trajectory that the available truth allows to compute.
struct TrajectoryScore {
    std::optional<AteResult> absolute;  ///< set, like `relative`, if there is a reference trajectory
    std::optional<RpeResult> relative;
    std::optional<RelationErrors> relations;
};

/// Compares with a reference trajectory. Throws Error if the two have no moment in common.
TrajectoryScore score_against(const Trajectory& estimate, const Trajectory& reference,
                              const ScoreOptions& options = {});

/// The figures of a score that exist, without the poses behind them. In JSON, the keys are the names of the members.
struct ScoreFigures {
    std::optional<ErrorStatistics> ate_m;
    std::optional<ErrorStatistics> error_x_m;
    std::optional<ErrorStatistics> error_y_m;
    std::optional<ErrorStatistics> rpe_m;
    std::optional<ErrorStatistics> rpe_deg;
    std::optional<ErrorStatistics> relations_m;
    std::optional<ErrorStatistics> relations_deg;
    std::optional<ErrorStatistics> relations_short_m;
    std::optional<ErrorStatistics> relations_short_deg;
    std::optional<ErrorStatistics> relations_long_m;
    std::optional<ErrorStatistics> relations_long_deg;
    std::optional<Pose2> reference_from_estimate;  ///< the alignment
    std::optional<std::size_t> relations_skipped;
};

ScoreFigures figures_of(const TrajectoryScore& score);
void to_json(Json& json, const ScoreFigures& figures);
void from_json(const Json& json, ScoreFigures& figures);

/// A table with one row per kind of error: its statistics.
Table score_table(const TrajectoryScore& score);

/// The figures as JSON.
Json score_json(const TrajectoryScore& score);

}  // namespace ddtool

#include "scores/trajectory_score.hpp"

#include <array>

namespace ddtool {
namespace {

struct NamedError {
    const char* title;
    const char* key;
    std::optional<ErrorStatistics> ScoreFigures::*member;
};

constexpr std::array<NamedError, 11> errors{{
    {"ATE [m]", "ate_m", &ScoreFigures::ate_m},
    {"Error_x [m]", "error_x_m", &ScoreFigures::error_x_m},
    {"Error_y [m]", "error_y_m", &ScoreFigures::error_y_m},
    {"RPE translation [m]", "rpe_m", &ScoreFigures::rpe_m},
    {"RPE rotation [deg]", "rpe_deg", &ScoreFigures::rpe_deg},
    {"relations, translation [m]", "relations_m", &ScoreFigures::relations_m},
    {"relations, rotation [deg]", "relations_deg", &ScoreFigures::relations_deg},
    {"under 5 s, translation [m]", "relations_short_m", &ScoreFigures::relations_short_m},
    {"under 5 s, rotation [deg]", "relations_short_deg", &ScoreFigures::relations_short_deg},
    {"over 60 s, translation [m]", "relations_long_m", &ScoreFigures::relations_long_m},
    {"over 60 s, rotation [deg]", "relations_long_deg", &ScoreFigures::relations_long_deg},
}};

constexpr const char* alignment_key = "reference_from_estimate";
constexpr const char* skipped_key = "relations_skipped";

}  // namespace

TrajectoryScore score_against(const Trajectory& estimate, const Trajectory& reference, const ScoreOptions& options) {
    TrajectoryScore score;
    score.absolute = absolute_trajectory_error(estimate, reference, options.ate);
    score.relative = relative_pose_error(score.absolute->pairs, options.rpe_delta);
    return score;
}

ScoreFigures figures_of(const TrajectoryScore& score) {
    ScoreFigures figures;
    if (score.absolute) {
        figures.ate_m = score.absolute->translation_m;
        figures.error_x_m = score.absolute->error_x_m;
        figures.error_y_m = score.absolute->error_y_m;
        figures.reference_from_estimate = score.absolute->reference_from_estimate;
    }
    if (score.relative) {
        figures.rpe_m = score.relative->translation_m;
        figures.rpe_deg = score.relative->rotation_deg;
    }
    if (score.relations) {
        figures.relations_m = score.relations->all.translation_m;
        figures.relations_deg = score.relations->all.rotation_deg;
        if (const auto& short_ones = score.relations->short_ones) {
            figures.relations_short_m = short_ones->translation_m;
            figures.relations_short_deg = short_ones->rotation_deg;
        }
        if (const auto& long_ones = score.relations->long_ones) {
            figures.relations_long_m = long_ones->translation_m;
            figures.relations_long_deg = long_ones->rotation_deg;
        }
        figures.relations_skipped = score.relations->skipped;
    }
    return figures;
}

void to_json(Json& json, const ScoreFigures& figures) {
    json = Json::object();
    for (const NamedError& error : errors) {
        if (const auto& statistics = figures.*error.member) {
            json[error.key] = *statistics;
        }
    }
    if (const auto& alignment = figures.reference_from_estimate) {
        json[alignment_key] = {{"x_m", alignment->x_m}, {"y_m", alignment->y_m}, {"theta_rad", alignment->theta_rad}};
    }
    if (figures.relations_skipped) {
        json[skipped_key] = *figures.relations_skipped;
    }
}

void from_json(const Json& json, ScoreFigures& figures) {
    figures = {};
    for (const NamedError& error : errors) {
        if (const auto found = json.find(error.key); found != json.end()) {
            figures.*error.member = found->get<ErrorStatistics>();
        }
    }
    if (const auto found = json.find(alignment_key); found != json.end()) {
        figures.reference_from_estimate =
            Pose2{found->at("x_m").get<double>(), found->at("y_m").get<double>(), found->at("theta_rad").get<double>()};
    }
    if (const auto found = json.find(skipped_key); found != json.end()) {
        figures.relations_skipped = found->get<std::size_t>();
    }
}

Table score_table(const TrajectoryScore& score) {
    const ScoreFigures figures = figures_of(score);
    Table table({{"error"}, {"rmse", 4}, {"mean", 4}, {"median", 4}, {"std", 4}, {"min", 4}, {"max", 4}, {"count"}});
    for (const NamedError& error : errors) {
        if (const auto& each = figures.*error.member) {
            table.add_row({error.title, each->rmse, each->mean, each->median, each->std, each->min, each->max,
                           static_cast<std::int64_t>(each->count)});
        }
    }
    return table;
}

Json score_json(const TrajectoryScore& score) { return figures_of(score); }

}  // namespace ddtool
